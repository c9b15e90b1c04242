#pragma once

#include "widgets/workspace/workspace.h"

#include <QString>

#include <memory>
#include <vector>

namespace mirrorball::studio {

/// The maps of a scene that the Map dock can show: its probe, what is made of it, and the signed error of a method that was picked.
enum class MapStage { Probe, Specular, Diffuse, Background, Error };

/// What a stage has to show now.
struct StageMaps {
    std::vector<std::shared_ptr<const EnvironmentMap>> levels{}; ///< the largest first; each keeps the others alive, none is copied
    QString why{};                                               ///< why there are none, in words
};

StageMaps mapsOf(MapStage stage, const Workspace& workspace);

} // namespace mirrorball::studio
