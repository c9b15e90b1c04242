#include "sidecar.h"

#include "reading_json.h"

#include "core/base/version.h"
#include "core/filter/lobe_row.h"
#include "core/image/image_format.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace mirrorball {

namespace {

using Json = nlohmann::ordered_json;

std::string borderText(const MapLayout& layout, int faceBorder)
{
    if (faceBorder > 0)
        return std::to_string(faceBorder) +
               " texels around each face, copied from the neighboring faces, at corners from one that meets there";
    switch (mapping(layout.kind).charts) {
    case Charts::Halves:
        return "discs inscribed, with " + std::to_string(layout.border) +
               " texels kept free around each; texels outside a disc continue the paraboloid";
    case Charts::Disc:
        return "disc inscribed; texels outside it continue the mapping through the rim";
    case Charts::Whole:
    case Charts::Faces:
        break;
    }
    return "none: texels beyond an edge are found across the seam";
}

Json lobeJson(const Lobe& lobe)
{
    const bool isGgx = lobe.kind == LobeKind::Ggx;
    if (isGgx && lobe.isMirror())
        return {{"kind", "mirror"}};
    const LobeRow& row = rowOf(lobe.kind);
    Json json = Json::object();
    json["kind"] = row.word;
    if (isGgx)
        json["roughness"] = std::sqrt(lobe.alpha);
    if (row.value)
        json[std::string(row.parameter)] = lobe.*row.value;
    return json;
}

const ImageFormat& formatOf(const ExportTarget& target) { return writableFormat(target.fileName()); }

/// What the texels of a file are, as its format stores them.
struct Stored {
    const ImageFormat& format;
    std::string_view word; ///< of a sample

    explicit Stored(const ExportTarget& target)
        : format(formatOf(target)), word(sampleWord(format, target.half ? SampleType::Half : SampleType::Float))
    {
    }
    bool isShown() const { return format.samples == StoredSamples::Byte; }
};

Json levelsJson(const ExportPlan& planned, const std::vector<EnvironmentMap>& levels)
{
    Json list = Json::array();
    for (size_t i = 0; i < levels.size(); ++i) {
        const MapLayout& layout = levels[i].layout;
        Json level = {{"level", i}, {"size", layout.size}, {"width", layout.width()}, {"height", layout.height()}};
        if (layout.border > 0)
            level["border"] = layout.border;
        if (i < planned.map.filters.size())
            level["lobe"] = lobeJson(planned.map.filters[i].options.lobe);
        list.push_back(std::move(level));
    }
    return list;
}

/// What all kinds begin with.
Json opened(const ExportTarget& target, const std::vector<std::filesystem::path>& files)
{
    Json json;
    json["mirrorball_sidecar"] = 1;
    json["mirrorball_version"] = version();
    json["name"] = target.name;
    json["kind"] = wordOf(target.kind);
    json["files"] = Json::array();
    for (const std::filesystem::path& file : files)
        json["files"].push_back(file.filename().string());
    return json;
}

std::string closed(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string paintedAxesText(SphereMapIndex index, MapSpace space)
{
    const std::string where = space == MapSpace::World ? " in world space" : " in eye space";
    return (index == SphereMapIndex::Normal
                ? "(s, t) = n.xy / 2 + 1/2 in the disc's square, n the surface normal" + where
                : "GL_SPHERE_MAP: (s, t) = r.xy / (2 sqrt(rx^2 + ry^2 + (rz + 1)^2)) + 1/2 in the disc's square, r the mirrored view ray" +
                      where) +
           "; the center is +Z, right is +X and top +Y";
}

const char* opacityText(const PaintedSize& picture, const Stored& stored)
{
    if (picture.channels != 4)
        return "opaque everywhere";
    if (!stored.format.alpha)
        return "none, for the format has no alpha channel: what is transparent is over black";
    return stored.isShown() ? "in the alpha channel; colors are not multiplied by it" : "in the alpha channel; colors are multiplied by it";
}

/// How the coarser levels came about.
const char* paintedRuleText(const ExportPlan& planned, const SphereMapDocument& map)
{
    if (!planned.target.mips)
        return "one level";
    if (planned.painted->levels == SphereMapLevels::Authored && hasAuthoredLevels(map))
        return "authored: each level is painted by itself, with widths in its own pixels; do not make them anew from the largest";
    return "averages: each texel of a level is the mean of those that it covers in the level before";
}

} // namespace

std::string_view indexedBy(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Source:
        return "direction";
    case ExportKind::Diffuse:
        return "normal";
    case ExportKind::Specular:
    case ExportKind::Chain:
    case ExportKind::Painted: // which has a document to say so: paintedSidecar()
        break;
    }
    return "reflection";
}

std::string sidecar(const Scene& scene, const ExportPlan& planned, const std::vector<EnvironmentMap>& levels,
                    const std::vector<std::filesystem::path>& files, const WorkRecord& work)
{
    const ExportTarget& target = planned.target;
    const Stored stored(target);
    const bool diffuse = target.kind == ExportKind::Diffuse;
    const MapLayout& layout = levels.front().layout;
    Json json = opened(target, files);
    json["parameterization"] = name(layout.kind);
    json["size"] = layout.size;
    json["width"] = layout.width();
    json["height"] = layout.height();
    json["border"] = target.faceBorder() > 0 ? target.faceBorder() : layout.border;
    json["border_rule"] = borderText(layout, target.faceBorder());
    json["handedness"] = "right";
    json["up"] = "+Y";
    json["axes"] = mapping(layout.kind).axes;
    json["value"] = diffuse ? "irradiance over pi for the surface normal d; a constant environment of 1 gives 1"
                            : "radiance arriving from direction d, which points away from the object; filtered maps keep a constant 1";
    json["indexed_by"] = indexedBy(target.kind);
    json["color_space"] = stored.isShown() ? "sRGB, tone-mapped (filmic)" : "linear, Rec.709 primaries, D65";
    json["sample_type"] = stored.word;
    json["lobe"] = target.kind == ExportKind::Chain ? Json("chain") : lobeJson(planned.map.filters.front().options.lobe);
    json["levels"] = levelsJson(planned, levels);
    json["level_rule"] = target.kind == ExportKind::Chain ? "roughness = level / (levels - 1); alpha = roughness^2; each level is filtered "
                                                            "from the probe itself"
                         : planned.map.pyramid            ? "each level is the halving of the one before, weighted by solid angle"
                                                          : "one level";
    json["probe"] = {{"source", scene.probe.source}, {"yaw_degrees", scene.probe.yawDeg}, {"exposure", scene.probe.exposure}};
    json["probe"].update(askedOf(scene.probe.reading));
    if (!work.methods.empty())
        json["filter"] = {{"method", work.methodText()}, {"band_limit", work.bandLimit}, {"predicted_rel_rms", work.predicted.relRms}};
    return closed(json);
}

std::string paintedSidecar(const Scene& scene, const ExportPlan& planned, const SphereMapDocument& map,
                           const std::vector<PaintedSize>& levels, const std::vector<std::filesystem::path>& files)
{
    const ExportTarget& target = planned.target;
    const Stored stored(target);
    const PaintedSize& picture = levels.front();
    Json json = opened(target, files);
    json["parameterization"] = "sphere";
    json["size"] = target.size;
    json["width"] = picture.edge;
    json["height"] = picture.edge;
    json["border"] = target.border;
    json["border_rule"] = "disc inscribed, with " + std::to_string(target.border) +
                          " texels around its square; texels outside the disc have the color of the nearest point of its rim";
    json["handedness"] = "right";
    json["up"] = "+Y";
    json["axes"] = paintedAxesText(map.index, scene.material.sphereMap.space);
    json["value"] = "the painted color of the surface";
    json["indexed_by"] = wordOf(map.index);
    json["color_space"] = stored.isShown() ? "sRGB, clipped to 0..1" : "linear, Rec.709 primaries, D65";
    json["sample_type"] = stored.word;
    json["opacity"] = opacityText(picture, stored);
    json["levels"] = Json::array();
    for (size_t i = 0; i < levels.size(); ++i)
        json["levels"].push_back({{"level", i}, {"size", levels[i].edge}, {"width", levels[i].edge}, {"height", levels[i].edge}});
    json["level_rule"] = paintedRuleText(planned, map);
    const SphereMapSettings& settings = scene.material.sphereMap;
    json["sphere_map"] = {{"source", settings.document ? Json("embedded in the scene") : Json(settings.source)}, {"title", map.title}};
    return closed(json);
}

} // namespace mirrorball
