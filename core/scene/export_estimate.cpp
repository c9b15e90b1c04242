#include "export_estimate.h"

#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

/// How a format stores a texel of three channels, and how small compression makes it on average.
struct Storage {
    std::int64_t texelBytes = 12;
    double ratio = 1.0;
};

/// Ratios of files to texels: means over four 1k probes (studio, sky, night, interior) as cube and latlong of 256; `smooth`: filtered with
/// phong
/// 50. Of painted maps: means over the built-in ones at 256.
Storage storage(const ExportTarget& target, bool smooth)
{
    const std::filesystem::path file = target.fileName();
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool painted = target.kind == ExportKind::Painted;
    if (holdsMips(file)) {
        if (target.half)
            return {6, painted ? 0.31 : smooth ? 0.27 : 0.6};
        return {12, extension == ".exr" ? 1.0 : smooth ? 0.56 : 0.72};
    }
    if (extension == ".hdr" || extension == ".pic" || extension == ".rgbe")
        return {4, smooth ? 0.55 : 0.78};
    if (extension == ".pfm")
        return {12, 1.0};
    return {3, painted ? 0.19 : smooth ? 0.12 : 0.38};
}

std::vector<MapLayout> levelLayouts(const ExportPlan& plan)
{
    std::vector<MapLayout> layouts;
    if (plan.painted)
        for (int size = plan.target.size; size >= 1; size = plan.target.mips ? size / 2 : 0)
            layouts.push_back({Parameterization::Sphere, size, 0});
    for (const PrefilterOptions& filter : plan.map.filters)
        layouts.push_back(filter.target);
    if (plan.map.pyramid)
        for (int i = 1; i < levelCount(layouts.front()); ++i)
            layouts.push_back(levelLayout(layouts.front(), i));
    return layouts;
}

constexpr std::int64_t headerBytes = 600; ///< of an image file
constexpr std::int64_t sidecarBytes = 1500;
constexpr std::int64_t sidecarLevelBytes = 160;

} // namespace

std::vector<ExportEstimate> estimateExports(const Plan& plan, const MapLayout& probe)
{
    std::vector<ExportEstimate> estimates;
    for (const ExportPlan& planned : plan.exports) {
        const ExportTarget& target = planned.target;
        const std::vector<MapLayout> layouts = levelLayouts(planned);
        ExportEstimate estimate{.name = target.name, .levels = static_cast<int>(layouts.size())};
        for (const std::filesystem::path& file : mapFiles(target.fileName(), layouts))
            estimate.files.push_back(file.string());
        bool smooth = false;
        for (const PrefilterOptions& filter : planned.map.filters) {
            const PrefilterPlan prediction = planPrefilter(filter, {.width = 2 * latlongHeight(probe)});
            smooth |= prediction.filtered;
            estimate.seconds += prediction.filtered ? prediction.predictedSeconds : 0.0;
        }
        estimate.seconds += planned.paintingSeconds;
        const Storage texel = storage(target, smooth);
        for (const MapLayout& layout : layouts)
            estimate.texelBytes += texel.texelBytes * layout.width() * layout.height();
        estimate.fileBytes = std::llround(texel.ratio * static_cast<double>(estimate.texelBytes)) +
                             headerBytes * static_cast<std::int64_t>(estimate.files.size()) + sidecarBytes +
                             sidecarLevelBytes * static_cast<std::int64_t>(layouts.size());
        estimate.files.push_back(target.name + ".json");
        estimates.push_back(std::move(estimate));
    }
    return estimates;
}

std::string byteText(std::int64_t bytes)
{
    if (bytes < 1000)
        return std::to_string(bytes) + " bytes";
    constexpr std::array units{"kB", "MB", "GB", "TB"};
    double value = static_cast<double>(bytes) / 1000.0;
    size_t unit = 0;
    while (value >= 999.5 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value < 9.95 ? "%.1f %s" : "%.0f %s", value, units[unit]);
    return text.data();
}

} // namespace mirrorball
