#include "live_picture.h"

#include "core/base/error.h"

#include <utility>

namespace mirrorball {

namespace {

/// White multiplies by 1; normals that all point outwards tilt none.
PictureLevels withoutEffect(SurfacePictureUse use)
{
    Image one(1, 1, 3, 1.0f);
    if (use == SurfacePictureUse::Normal)
        one.texels = {0.0f, 0.0f, 1.0f};
    return std::make_shared<const std::vector<Image>>(1, std::move(one));
}

} // namespace

PictureLevels LivePicture::update(const Scene& scene, const std::optional<SurfacePicturePlan>& plan, const JobControl& job,
                                  WorkRecord& record)
{
    if (!plan) {
        *this = {};
        return nullptr;
    }
    std::error_code missing;
    const std::string path = resolved(scene, plan->source);
    const auto time = std::filesystem::last_write_time(path, missing);
    if (m_plan == plan && m_path == path && m_time == time)
        return m_levels;
    const PictureLevels before = m_path == path && (m_problem.empty() || m_isKept) ? m_levels : nullptr;
    LivePicture now;
    now.m_plan = plan;
    now.m_path = path;
    now.m_time = time;
    timedStage(record.stages, "read " + plan->name, [&] {
        try {
            now.m_levels = readSurfacePicture(scene, *plan, job);
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            now.m_problem = error.what();
            now.m_isKept = before != nullptr;
            now.m_levels = now.m_isKept ? before : withoutEffect(plan->use);
        }
    });
    *this = std::move(now);
    return m_levels;
}

} // namespace mirrorball
