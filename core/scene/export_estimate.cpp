#include "export_estimate.h"

#include "core/image/image_format.h"
#include "core/image/map_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

const ImageFormat& formatOf(const ExportTarget& target) { return writableFormat(target.fileName()); }

SampleType samplesOf(const ExportTarget& target) { return target.half ? SampleType::Half : SampleType::Float; }

/// Size of the files over that of their texels.
double ratioOf(const ExportTarget& target, bool smooth)
{
    const ImageFormat& format = formatOf(target);
    const CompressionRatios& ratios = format.half && target.half ? format.halfRatios : format.ratios;
    return target.kind == ExportKind::Painted ? ratios.painted : smooth ? ratios.smooth : ratios.plain;
}

constexpr std::int64_t headerBytes = 600; ///< of an image file
constexpr std::int64_t sidecarBytes = 1500;
constexpr std::int64_t sidecarLevelBytes = 160;

} // namespace

std::vector<ExportEstimate> estimateExports(const Plan& plan)
{
    std::vector<ExportEstimate> estimates;
    for (const ExportPlan& planned : plan.exports) {
        const ExportTarget& target = planned.target;
        const std::vector<MapLayout> layouts = levelLayouts(planned);
        ExportEstimate estimate{.name = target.name,
                                .levels = static_cast<int>(layouts.size()),
                                .isPainted = planned.painted.has_value(),
                                .seconds = planned.seconds};
        for (const std::filesystem::path& file : mapFiles(target.fileName(), layouts))
            estimate.files.push_back(file.string());
        bool smooth = false;
        for (const PlannedFilter& filter : planned.map.filters)
            smooth |= filter.plan.filtered;
        const std::int64_t texel = texelBytes(formatOf(target), samplesOf(target));
        for (const MapLayout& layout : layouts)
            estimate.texelBytes += texel * layout.width() * layout.height();
        estimate.fileBytes = std::llround(ratioOf(target, smooth) * static_cast<double>(estimate.texelBytes)) +
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
