#include "export.h"

#include "../atomic_file.h"
#include "../error.h"
#include "../image/map_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>

namespace mirrorball {

namespace {

using Json = nlohmann::ordered_json;

/// Where the axes lie in a map of each kind, as parameterization.h draws it.
const char* axesText(Parameterization kind)
{
    switch (kind) {
    case Parameterization::Latlong:
        return "the centre is +Z, the left quarter +X, the top +Y; d = (sin(lon) cos(lat), sin(lat), cos(lon) cos(lat)), lon = pi - 2 pi u, "
               "lat = pi/2 - pi v; texel centres at (i + 1/2)/N";
    case Parameterization::Cube: return "faces +X -X +Y -Y +Z -Z, each with OpenGL's face axes (OpenGL 4.5, table 8.19)";
    case Parameterization::Sphere:
        return "GL_SPHERE_MAP: (s, t) = r.xy / (2 sqrt(rx^2 + ry^2 + (rz + 1)^2)) + 1/2; the centre is +Z, right +X, top +Y";
    case Parameterization::Angular:
        return "the distance from the centre is the angle from +Z over pi, in radii of the disc; left is +X, top +Y";
    case Parameterization::Paraboloid:
        return "front half (z >= 0) on the left: (x, y) = r.xy / (1 + r.z); back half on the right: (x, y) = r.xy / (1 - r.z); right is +X "
               "and top +Y in both";
    case Parameterization::Octahedral: return "+Y at the centre, -Y at the corners; right is +X and down +Z";
    }
    return "";
}

std::string borderText(const MapLayout& layout)
{
    if (layout.kind == Parameterization::Paraboloid)
        return "discs inscribed, with " + std::to_string(layout.border) +
               " texels kept free around each; texels outside a disc continue the paraboloid";
    if (layout.kind == Parameterization::Sphere || layout.kind == Parameterization::Angular)
        return "disc inscribed; texels outside it continue the mapping through the rim";
    return "none: texels beyond an edge are found across the seam";
}

Json lobeJson(const Lobe& lobe)
{
    switch (lobe.kind) {
    case LobeKind::Phong: return {{"kind", "phong"}, {"exponent", lobe.exponent}};
    case LobeKind::Diffuse: return {{"kind", "diffuse"}};
    case LobeKind::Ggx:
        if (lobe.isMirror())
            return {{"kind", "mirror"}};
        return {{"kind", "ggx"}, {"roughness", std::sqrt(lobe.alpha)}, {"alpha", lobe.alpha}};
    case LobeKind::Tabulated: return {{"kind", "tabulated"}};
    }
    return {};
}

/// What the texels of a file are, as its format stores them.
std::string sampleType(const ExportTarget& target)
{
    const std::filesystem::path file = target.fileName();
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (holdsMips(file))
        return target.half ? "half" : "float";
    return extension == ".hdr" || extension == ".pic" || extension == ".rgbe" ? "rgbe" : extension == ".pfm" ? "float" : "uint8";
}

Json levelsJson(const ExportPlan& planned, const std::vector<EnvironmentMap>& levels)
{
    Json list = Json::array();
    for (size_t i = 0; i < levels.size(); ++i) {
        const MapLayout& layout = levels[i].layout;
        Json level = {{"level", i}, {"size", layout.size}, {"width", layout.width()}, {"height", layout.height()}};
        if (layout.border > 0)
            level["border"] = layout.border;
        if (i < planned.map.filters.size())
            level["lobe"] = lobeJson(planned.map.filters[i].lobe);
        list.push_back(std::move(level));
    }
    return list;
}

/// What a reader of the map must know, in one object.
Json sidecar(const Scene& scene, const ExportPlan& planned, const std::vector<EnvironmentMap>& levels,
             const std::vector<std::filesystem::path>& files, const WorkRecord& work)
{
    const ExportTarget& target = planned.target;
    const std::string samples = sampleType(target);
    const bool diffuse = target.kind == ExportKind::Diffuse;
    const MapLayout& layout = levels.front().layout;
    Json json;
    json["mirrorball_sidecar"] = 1;
    json["name"] = target.name;
    json["kind"] = words(target.kind)[static_cast<size_t>(target.kind)];
    json["files"] = Json::array();
    for (const std::filesystem::path& file : files)
        json["files"].push_back(file.filename().string());
    json["parameterization"] = name(layout.kind);
    json["size"] = layout.size;
    json["width"] = layout.width();
    json["height"] = layout.height();
    json["border"] = layout.border;
    json["border_rule"] = borderText(layout);
    json["handedness"] = "right";
    json["up"] = "+Y";
    json["axes"] = axesText(layout.kind);
    json["value"] = diffuse ? "irradiance over pi for the surface normal d; a constant environment of 1 gives 1"
                            : "radiance arriving from direction d, which points away from the object; filtered maps keep a constant 1";
    json["indexed_by"] = diffuse ? "normal" : target.kind == ExportKind::Source ? "direction" : "reflection";
    json["color_space"] = samples == "uint8" ? "sRGB, tone-mapped (filmic)" : "linear, Rec.709 primaries, D65";
    json["sample_type"] = samples;
    json["lobe"] = target.kind == ExportKind::Chain ? Json("chain") : lobeJson(planned.map.filters.front().lobe);
    json["levels"] = levelsJson(planned, levels);
    json["level_rule"] = target.kind == ExportKind::Chain ? "roughness = level / (levels - 1); alpha = roughness^2; each level is filtered "
                                                            "from the probe itself"
                         : planned.map.pyramid ? "each level is the halving of the one before, weighted by solid angle"
                                               : "one level";
    json["probe"] = {{"source", scene.probe.source}, {"yaw_degrees", scene.probe.yawDeg}, {"exposure", scene.probe.exposure}};
    if (!work.method.empty())
        json["filter"] = {{"method", work.method}, {"band_limit", work.bandLimit}, {"predicted_rel_rms", work.predictedError}};
    return json;
}

void writeText(const std::filesystem::path& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

/// Builds, writes and describes one export.
void exportOne(const Scene& scene, const ExportPlan& planned, SceneProbe& probe, const std::filesystem::path& folder,
               const JobControl& job, ExportOutcome& outcome)
{
    const ExportTarget& target = planned.target;
    WorkRecord work;
    const std::vector<EnvironmentMap> levels = buildMap(planned.map, probe, scene.probe.exposure, job, work);
    std::vector<std::filesystem::path> files = timedStage(work.stages, "save " + target.name, [&] {
        WriteOptions write{.sampleType = target.half ? SampleType::Half : SampleType::Float};
        write.attributes["mirrorball:indexed_by"] = target.kind == ExportKind::Diffuse ? "normal" : "reflection";
        return writeMap(folder / target.fileName(), levels, write);
    });
    const std::filesystem::path description = folder / (target.name + ".json");
    writeText(description, sidecar(scene, planned, levels, files, work).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    files.push_back(description);

    outcome.files.insert(outcome.files.end(), files.begin(), files.end());
    WorkRecord& record = outcome.record;
    record.stages.insert(record.stages.end(), std::make_move_iterator(work.stages.begin()), std::make_move_iterator(work.stages.end()));
    if (record.method.find(work.method) == std::string::npos)
        record.method += (record.method.empty() ? "" : ", ") + work.method;
    record.bandLimit = std::max(record.bandLimit, work.bandLimit);
    record.predictedError = std::max(record.predictedError, work.predictedError);
}

} // namespace

ExportOutcome exportScene(const Scene& scene, const std::filesystem::path& folder, const ExportOptions& options, const JobControl& job)
{
    if (scene.exports.empty())
        throw InvalidArgument("exports: the scene lists none; add at least {\"name\": \"specular\", \"kind\": \"specular\"} to \"exports\"");
    const Plan plan = makePlan(scene, probeLayout(scene), {.picture = false, .exports = options.only});
    ExportOutcome outcome;
    constexpr float reading = 0.2f; // share of the progress
    SceneProbe probe = openProbe(scene, plan, partOf(job, 0.0f, reading), outcome.record);

    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw WorkError(folder.string() + ": cannot be made a folder" + (error ? ": " + error.message() : "") + "; choose another one");
    const float share = (1.0f - reading) / static_cast<float>(plan.exports.size());
    for (size_t i = 0; i < plan.exports.size(); ++i) {
        const float from = reading + share * static_cast<float>(i);
        exportOne(scene, plan.exports[i], probe, folder, partOf(job, from, from + share), outcome);
    }
    return outcome;
}

} // namespace mirrorball
