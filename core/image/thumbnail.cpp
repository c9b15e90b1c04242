#include "thumbnail.h"

#include "builtin_probes.h"
#include "probe_picture.h"
#include "reproject.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mirrorball {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";
constexpr int blockTexels = 1 << 18;
constexpr std::int64_t heldTexels = std::int64_t{1} << 25;

/// Averages an image over areas while its rows arrive: each texel of the small image is the mean of the part of the large one that it
/// covers.
class AreaReducer {
public:
    AreaReducer(int width, int height, int smallWidth, int smallHeight)
        : m_width(width), m_height(height), m_small(smallWidth, smallHeight, 3),
          m_sums(static_cast<size_t>(smallWidth) * static_cast<size_t>(smallHeight) * 3, 0.0),
          m_rowSums(static_cast<size_t>(smallWidth) * 3)
    {
    }

    void addRows(int firstRow, int rows, const float* rgb)
    {
        for (int y = firstRow; y < firstRow + rows; ++y, rgb += static_cast<size_t>(m_width) * 3)
            addRow(y, rgb);
    }

    Image finish()
    {
        const double area = static_cast<double>(m_width) / m_small.width * m_height / m_small.height;
        for (size_t i = 0; i < m_sums.size(); ++i)
            m_small.texels[i] = static_cast<float>(m_sums[i] / area);
        return std::move(m_small);
    }

private:
    /// The two small texels that a large one covers, and how much of it falls to the second.
    struct Split {
        int first = 0;
        double second = 0.0;
    };
    static Split split(int at, int large, int few)
    {
        const double scale = static_cast<double>(few) / large;
        const int first = std::min(static_cast<int>(at * scale), few - 1);
        const double end = (at + 1) * scale;
        return {first, first + 1 < few ? std::clamp((end - (first + 1)) / scale, 0.0, 1.0) : 0.0};
    }

    void addRow(int y, const float* rgb)
    {
        std::fill(m_rowSums.begin(), m_rowSums.end(), 0.0);
        for (int x = 0; x < m_width; ++x, rgb += 3) {
            const Split at = split(x, m_width, m_small.width);
            double* sum = m_rowSums.data() + static_cast<size_t>(at.first) * 3;
            for (int c = 0; c < 3; ++c)
                sum[c] += (1.0 - at.second) * rgb[c];
            if (at.second > 0.0)
                for (int c = 0; c < 3; ++c)
                    sum[3 + c] += at.second * rgb[c];
        }
        const Split at = split(y, m_height, m_small.height);
        double* sums = m_sums.data() + static_cast<size_t>(at.first) * m_rowSums.size();
        for (size_t i = 0; i < m_rowSums.size(); ++i)
            sums[i] += (1.0 - at.second) * m_rowSums[i];
        if (at.second > 0.0)
            for (size_t i = 0; i < m_rowSums.size(); ++i)
                sums[m_rowSums.size() + i] += at.second * m_rowSums[i];
    }

    int m_width, m_height;
    Image m_small;
    std::vector<double> m_sums, m_rowSums;
};

/// The detection of an image that was reduced to `width` x `height`.
Detection scaled(const Detection& full, int fullWidth, int width, int height)
{
    Detection detection = full;
    if (full.arrangement == Arrangement::Constant)
        return detection;
    const double factor = static_cast<double>(width) / fullWidth;
    detection.layout.size = full.arrangement == Arrangement::EdgeSampledLatlong
                                ? height
                                : std::max(1, static_cast<int>(std::lround(full.layout.size * factor)));
    if (full.layout.border > 0)
        detection.layout.border =
            std::clamp(static_cast<int>(std::lround(full.layout.border * factor)), 0, (detection.layout.size - 1) / 2);
    return detection;
}

struct Reduction {
    int width = 0, height = 0;
};

/// The size of the reduced image: the arrangement's unit (face, disc, height of a latlong) shrinks to a whole number of texels.
Reduction reduction(const ImageFileInfo& info, const Detection& detection, int thumbnailHeight)
{
    const int unit = detection.layout.size;
    const int wanted = detection.layout.kind == Parameterization::Cube ? thumbnailHeight : 2 * thumbnailHeight;
    if (unit <= wanted || detection.arrangement == Arrangement::Constant || detection.faceBorder > 0)
        return {info.width, info.height};
    const auto shrink = [&](int edge) { return std::max(2, static_cast<int>(std::lround(static_cast<double>(edge) * wanted / unit))); };
    return {shrink(info.width), shrink(info.height)};
}

/// The coarsest mip level that is not smaller than the reduction, in the proportions of the file.
int usefulLevel(const ImageFileInfo& info, const Reduction& to)
{
    int level = 0;
    while (level + 1 < info.levels && info.width % (2 << level) == 0 && info.height % (2 << level) == 0 &&
           (info.width >> (level + 1)) >= to.width && (info.height >> (level + 1)) >= to.height)
        ++level;
    return level;
}

using Rows = std::function<void(int firstRow, int rows, const float* rgb)>;

ReducedProbe reducedFile(const std::string& path, const ThumbnailOptions& options, bool mips, const JobControl& job, const Rows& alsoSees)
{
    const auto reader = openProbePicture(path, options.reading);
    ReducedProbe result{.info = reader->info()};
    result.detection = detectLayout(result.info, options.reading);
    const Reduction to = reduction(result.info, result.detection, options.height);
    if (const int level = mips && options.reading == ProbeReading{} ? usefulLevel(result.info, to) : 0; level > 0) {
        Image image = readLevel(path, level);
        result.repaired = repair(image, NegativePolicy::Keep);
        AreaReducer reducer(image.width, image.height, to.width, to.height);
        reducer.addRows(0, image.height, image.texels.data());
        result.image = reducer.finish();
        result.fromMip = true;
        return result;
    }
    const int width = result.info.width, height = result.info.height;
    AreaReducer reducer(width, height, to.width, to.height);
    const int block = std::max(1, blockTexels / width);
    std::vector<float> rows(static_cast<size_t>(block) * static_cast<size_t>(width) * 3);
    for (int y = 0; y < height; y += block) {
        job.checkStop();
        const int count = std::min(block, height - y);
        reader->readRows(y, count, rows.data());
        reducer.addRows(y, count, rows.data());
        if (alsoSees)
            alsoSees(y, count, rows.data());
        if (job.progress)
            job.progress(static_cast<float>(y + count) / static_cast<float>(height));
    }
    result.repaired = reader->report();
    result.image = reducer.finish();
    return result;
}

ReducedProbe reducedBuiltin(const std::string& probe, const ThumbnailOptions& options, const JobControl& job)
{
    ReducedProbe result;
    const MapLayout layout{Parameterization::Latlong, std::min(options.height, builtinProbeLayout.size), 0};
    result.image = renderBuiltinProbe(std::string_view(probe).substr(builtinPrefix.size()), layout, job).image;
    result.info = {
        .path = probe, .format = "builtin", .width = builtinProbeLayout.width(), .height = builtinProbeLayout.height(), .channels = 3};
    result.detection = {builtinProbeLayout, Arrangement::Whole, "built in", true};
    result.detection.orientation = orientation(options.reading);
    return result;
}

void checkHeight(const ThumbnailOptions& options)
{
    if (options.height < 1 || options.height > 1024)
        throw InvalidArgument("height: a thumbnail has 1 to 1024 rows; it has " + std::to_string(options.height));
}

} // namespace

ReducedProbe reduceProbe(const std::string& probe, const ThumbnailOptions& options, const JobControl& job)
{
    checkHeight(options);
    return probe.starts_with(builtinPrefix) ? reducedBuiltin(probe, options, job) : reducedFile(probe, options, true, job, {});
}

EnvironmentMap thumbnailOf(const ReducedProbe& probe, int height, std::optional<Parameterization> kind, const JobControl& job)
{
    Detection full = probe.detection;
    if (kind && *kind != full.layout.kind) {
        full = detectLayout(probe.info, kind);
        full.orientation = probe.detection.orientation;
    }
    const EnvironmentMap map = toEnvironmentMap(probe.image, scaled(full, probe.info.width, probe.image.width, probe.image.height), job);
    return reproject(map, {.target = {Parameterization::Latlong, height, 0}}, job);
}

std::vector<Parameterization> possibleKinds(const ReducedProbe& probe)
{
    std::vector<Parameterization> kinds{probe.detection.layout.kind};
    if (probe.info.format == "builtin" || probe.detection.arrangement == Arrangement::Constant)
        return kinds;
    for (const Parameterization kind : allParameterizations)
        try {
            if (kind != kinds.front() && detectLayout(probe.info, kind).layout.kind == kind)
                kinds.push_back(kind);
        } catch (const FileError&) { // the shape does not fit
        }
    return kinds;
}

ProbeSurvey surveyProbe(const std::string& probe, const ThumbnailOptions& options, const JobControl& job)
{
    checkHeight(options);
    ProbeSurvey survey;
    if (probe.starts_with(builtinPrefix)) {
        survey.reduced = reducedBuiltin(probe, options, job);
        survey.statistics = statistics(renderBuiltinProbe(std::string_view(probe).substr(builtinPrefix.size()), builtinProbeLayout, job));
        return survey;
    }
    const ImageFileInfo info = openProbePicture(probe, options.reading)->info();
    const Detection detection = detectLayout(info, options.reading);
    if (detection.arrangement == Arrangement::Whole && detection.faces.empty() && detection.orientation == glm::dmat3(1.0)) {
        StatisticsBuilder builder(detection.layout);
        survey.reduced = reducedFile(probe, options, false, job,
                                     [&](int firstRow, int rows, const float* rgb) { builder.addRows(firstRow, rows, rgb); });
        survey.statistics = builder.finish();
        return survey;
    }
    Image whole;
    const bool held = std::int64_t{info.width} * info.height <= heldTexels;
    survey.reduced = reducedFile(probe, options, false, job, [&](int firstRow, int rows, const float* rgb) {
        if (!held)
            return;
        if (whole.empty())
            whole = Image(info.width, info.height, 3);
        std::copy_n(rgb, static_cast<size_t>(rows) * static_cast<size_t>(info.width) * 3, whole.row(firstRow));
    });
    const Image& small = survey.reduced.image;
    survey.statistics = statistics(held ? toEnvironmentMap(std::move(whole), detection, job)
                                        : toEnvironmentMap(small, scaled(detection, info.width, small.width, small.height), job));
    return survey;
}

} // namespace mirrorball
