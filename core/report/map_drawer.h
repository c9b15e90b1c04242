#pragma once

#include "core/image/environment_map.h"

#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

/// Draws a sphere that mirrors a map, so that a report can tell what looking maps up costs a picture. core/preview does it in OpenGL.
class MapDrawer {
public:
    virtual ~MapDrawer() = default;
    /// One picture, finished when this returns. Levels that were drawn last, told by their pointer, are where they are needed already.
    /// @throws WorkError when there is no GPU context or it fails
    virtual void draw(const std::shared_ptr<const std::vector<EnvironmentMap>>& levels) = 0;
    /// What it draws with and how large: "640 x 480, llvmpipe (LLVM 15.0.6, 256 bits)". @throws WorkError
    virtual std::string description() = 0;
};

} // namespace mirrorball
