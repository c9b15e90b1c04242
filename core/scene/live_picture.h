#pragma once

#include "scene_maps.h"

#include <filesystem>
#include <optional>
#include <string>

namespace mirrorball {

/// A picture on the mesh of a scene that is being edited: read again only when another is named or its file has changed. One that cannot be
/// read does not stop the picture: what its file held before is shown, or the object without it.
class LivePicture {
public:
    /// @return what the plan asks for, the same pointer while it is the same; null without a plan. @throws Cancelled
    PictureLevels update(const Scene& scene, const std::optional<SurfacePicturePlan>& plan, const JobControl& job, WorkRecord& record);

    /// Why the file cannot be read; empty where it can.
    const std::string& problem() const { return m_problem; }
    /// The file that is shown as it was before; empty where it is as it is.
    std::string keptFile() const { return m_isKept ? m_path : std::string(); }

private:
    std::optional<SurfacePicturePlan> m_plan{};
    std::string m_path{};
    std::filesystem::file_time_type m_time{};
    PictureLevels m_levels{};
    std::string m_problem{};
    bool m_isKept = false;
};

} // namespace mirrorball
