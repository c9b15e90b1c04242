#include "diagnosis.h"

#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/image/color.h"
#include "core/image/reproject.h"
#include "core/report/seam_ratio.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

int pictures(const MapLayout& layout) { return layout.kind == Parameterization::Cube ? 6 : 1; }

double meanLuminance(const EnvironmentMap& map) { return luminance(meanRadiance(map)); }

void scaleBy(Image& image, double factor)
{
    for (float& t : image.texels)
        t = static_cast<float>(t * factor);
}

/// The probe as the map's own directions show it, a latlong: only the yaw of a cube, whose texels are moved, else the whole orientation.
EnvironmentMap probeInPlace(const EnvironmentMap& latlong, const Orientation& orientation, Parameterization kind, const JobControl& job)
{
    if (kind == Parameterization::Cube)
        return orientation.restYaw == 0.0 ? latlong : reproject(latlong, {.target = latlong.layout, .yaw = orientation.restYaw}, job);
    if (orientation.storage.axes == glm::dmat3(1.0) && orientation.yaw == 0.0)
        return latlong;
    EnvironmentMap moved(latlong.layout);
    parallelRows(moved.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < moved.image.width; ++x) {
                const glm::dvec3 d = orientation.storage.axes * texelDirection(moved.layout, x, y);
                const glm::vec3 value = latlong.radiance(yawed(d, -orientation.yaw));
                std::copy_n(&value.x, 3, moved.image.texel(x, y));
            }
    });
    return moved;
}

EnvironmentMap truthOf(FilterSource& source, const Lobe& lobe, const MapLayout& layout, double tolerance, const JobControl& job)
{
    return prefilter(source, {.lobe = lobe, .target = layout, .tolerance = tolerance}, job).map;
}

/// As errorMetrics() has it, without what it sorts for.
double relRms(const EnvironmentMap& map, const EnvironmentMap& truth)
{
    const SolidAngles solidAngles(map.layout);
    double difference = 0.0, power = 0.0;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double t = truth.image.texel(x, y)[c], e = map.image.texel(x, y)[c] - t;
                difference += solidAngles.at(x, y) * e * e;
                power += solidAngles.at(x, y) * t * t;
            }
    return power > 0.0 ? std::sqrt(difference / power) : 0.0;
}

/// Texels of our convention where the map stores them: the inverse of inOurConvention().
Image asStored(const Image& ours, const FacePlaces& places)
{
    FacePlaces inverse{};
    const int n = 2;
    for (int i = 0; i < 6; ++i) {
        const FacePlace& place = places[static_cast<size_t>(i)];
        for (FaceTurn turn = 0; turn < allFaceTurns; ++turn) {
            bool undoes = true;
            for (int k = 0; k < 3; ++k) {
                const TurnedTexel there = turnedTexel(place.turn, n, k & 1, k >> 1), back = turnedTexel(turn, n, there.x, there.y);
                undoes = undoes && back.x == (k & 1) && back.y == k >> 1;
            }
            if (undoes)
                inverse[static_cast<size_t>(place.face)] = {i, turn};
        }
    }
    return inOurConvention(ours, inverse);
}

/// What is worked on: the levels, moved to our convention and with their curve undone.
struct Work {
    const StoredMap& map;
    const DiagnoseOptions& options;
    const JobControl& job;
    Diagnosis result{};
    std::vector<EnvironmentMap> levels{};
    std::optional<FilterSource> source{};
    std::optional<Spectrum> clippedSpectrum{};
    std::vector<EnvironmentMap> truths{};
};

void describeFile(Work& work)
{
    Diagnosis& d = work.result;
    d.container = work.map.container;
    d.texels = work.map.texels;
    d.shape = work.map.shape;
    d.kind = work.map.kind;
    d.certain = work.map.certain;
    d.files = work.map.files;
    d.hasSphericalHarmonics = work.map.metadata.contains("sh");
    for (size_t l = 0; l < work.map.levels.size(); ++l) {
        const StoredLevel& stored = work.map.levels[l];
        LevelDiagnosis level;
        level.layout = work.map.layout(l);
        level.repaired = stored.repaired;
        const auto [least, most] = std::minmax_element(stored.image.texels.begin(), stored.image.texels.end());
        level.smallest = *least;
        level.largest = *most;
        d.levels.push_back(level);
        work.levels.emplace_back(level.layout, stored.image);
        d.levels.back().mean = meanRadiance(work.levels.back());
    }
}

/// Moves texels to our convention; seams are those of the result.
void moveLevels(Work& work)
{
    if (work.map.kind == Parameterization::Cube && work.result.orientation)
        for (EnvironmentMap& level : work.levels)
            level.image = inOurConvention(level.image, work.result.orientation->places);
    for (size_t l = 0; l < work.levels.size(); ++l)
        work.result.levels[l].seam = seamSteps(work.levels[l]).ratio();
}

/// Whether the curve went over the probe before it was filtered: the roughest level tells.
void undoCurve(Work& work, const EnvironmentMap& probe)
{
    Diagnosis& d = work.result;
    const EnvironmentMap& first = work.levels.front();
    const EnvironmentMap truth = truthOf(*work.source, ggxLobe(d.orientation ? d.orientation->alpha : 0.0), first.layout, 1e-2, work.job);
    const int charts = pictures(first.layout);
    d.transfer = fitTransfer(averaged(first.image, charts, 32), averaged(truth.image, charts, 32));
    if (d.transfer.transfer == Transfer::Linear)
        return;
    if (work.levels.size() > 1) {
        EnvironmentMap curved = probe;
        for (float& t : curved.image.texels)
            t = static_cast<float>(transferred(isReversible(d.transfer.transfer) ? t : d.transfer.exposure * t, d.transfer.transfer));
        const EnvironmentMap& last = work.levels[std::min(work.levels.size() - 1, std::max<size_t>(1, work.levels.size() / 2))];
        const int size = quarterTexels(last.layout);
        const double before = fitLobe(lobeProblem(last, analyze(curved, lobeBandLimit, work.job), work.job), size).residual;
        const double after = fitLobe(lobeProblem({last.layout, undone(last.image, d.transfer.transfer)},
                                                 work.source->spectrum(lobeBandLimit, work.job), work.job),
                                     size)
                                 .residual;
        d.curveBeforeFiltering = before < 0.7 * after;
        if (d.curveBeforeFiltering) { // then the levels are right for the curved probe
            work.source = FilterSource(std::move(curved), work.job);
            return;
        }
    }
    for (EnvironmentMap& level : work.levels)
        level.image = undone(level.image, d.transfer.transfer);
}

/// Values that formats end at.
bool isFormatLimit(double value)
{
    constexpr std::array limits{1.0, 64.0, 255.0, 64512.0, 65024.0, 65408.0, 65504.0};
    return std::any_of(limits.begin(), limits.end(), [value](double limit) { return std::abs(value - limit) < 2e-3 * limit; });
}

/// Light above what level 0 holds, where that looks like an end: a format's largest value, or many texels of the same largest value.
void findClipping(Work& work, const EnvironmentMap& probe)
{
    Diagnosis& d = work.result;
    EnvironmentMap& first = work.levels.front();
    if (d.transfer.transfer > Transfer::SrgbDecoded)
        return;
    const EnvironmentMap truth = truthOf(*work.source, ggxLobe(0.0), first.layout, 1e-2, work.job);
    const int charts = pictures(first.layout);
    const double scale = fitTransfer(averaged(first.image, charts, 32), averaged(truth.image, charts, 32)).exposure;
    const double most = *std::max_element(first.image.texels.begin(), first.image.texels.end());
    Clipping clipping{.value = d.levels.front().largest};
    int same = 0;
    double lost = 0.0, all = 0.0;
    for (int y = 0; y < first.image.height; ++y)
        for (int x = 0; x < first.image.width; ++x) {
            const double w = texelSolidAngle(first.layout, x, y);
            bool brighter = false, end = false;
            for (int c = 0; c < 3; ++c) {
                const double value = scale * truth.image.texel(x, y)[c];
                lost += w * std::max(0.0, value - 1.02 * most);
                all += w * value;
                brighter = brighter || value > 1.05 * most;
                end = end || first.image.texel(x, y)[c] > 0.999 * most;
            }
            clipping.texels += brighter ? 1 : 0;
            same += end ? 1 : 0;
        }
    clipping.lost = all > 0.0 ? lost / all : 0.0;
    const bool ends =
        isFormatLimit(clipping.value) || d.levels.front().repaired.positiveInfinity > 0 || (same >= 4 && clipping.texels >= 4);
    if (!ends || clipping.lost < 1e-3 || clipping.texels == 0)
        return;
    // A smooth map has many texels near its largest value, and less light there than the probe.
    const int size = quarterTexels(first.layout);
    const LobeFit smooth = fitLobe(lobeProblem(first, work.source->spectrum(lobeBandLimit, work.job), work.job), size);
    if (smooth.alpha > 4.0 * unresolvedAlpha(size) && smooth.residual < 0.15)
        return;
    EnvironmentMap clipped = probe;
    for (float& t : clipped.image.texels)
        t = std::min(t, static_cast<float>(most / scale));
    work.clippedSpectrum = analyze(clipped, lobeBandLimit, work.job);
    d.clipping = clipping;
}

/// Where no lobe fits: whether one fits the probe clipped somewhere, as it was filtered from; in steps of a stop.
void findEarlyClipping(Work& work, const EnvironmentMap& probe)
{
    Diagnosis& d = work.result;
    if (work.clippedSpectrum || d.transfer.transfer != Transfer::Linear)
        return;
    const EnvironmentMap& level = work.levels[std::min<size_t>(work.levels.size() - 1, 1)];
    const int size = quarterTexels(level.layout);
    constexpr int coarse = 32; // degrees, of the search
    const double whole = fitLobe(lobeProblem(level, analyze(probe, coarse, work.job), work.job), size).residual;
    const double mean = meanLuminance(probe);
    const double most = *std::max_element(probe.image.texels.begin(), probe.image.texels.end());
    if (whole < 0.15 || most < 16.0 * mean)
        return;
    const auto clippedAt = [&](double value) {
        EnvironmentMap clipped = probe;
        for (float& t : clipped.image.texels)
            t = std::min(t, static_cast<float>(value));
        return clipped;
    };
    double best = 0.4 * whole, value = 0.0;
    for (double at = 0.5 * most; at > 2.0 * mean; at *= 0.5) {
        const double residual = fitLobe(lobeProblem(level, analyze(clippedAt(at), coarse, work.job), work.job), size).residual;
        if (residual < best) {
            best = residual;
            value = at;
        }
    }
    if (value == 0.0)
        return;
    const EnvironmentMap clipped = clippedAt(value);
    work.clippedSpectrum = analyze(clipped, lobeBandLimit, work.job);
    d.clipping = Clipping{.value = value, .lost = 1.0 - meanLuminance(clipped) / mean, .texels = 0, .filtered = true};
}

void fitLobes(Work& work)
{
    Diagnosis& d = work.result;
    const Spectrum& spectrum = work.source->spectrum(lobeBandLimit, work.job);
    int clipped = 0, whole = 0;
    for (size_t l = 0; l < work.levels.size(); ++l) {
        const int size = quarterTexels(work.levels[l].layout);
        LobeFit fit = fitLobe(lobeProblem(work.levels[l], spectrum, work.job), size);
        if (work.clippedSpectrum) {
            const LobeFit other = fitLobe(lobeProblem(work.levels[l], *work.clippedSpectrum, work.job), size);
            if (l > 0)
                ++(other.residual < 0.7 * fit.residual ? clipped : whole);
            if (other.residual < fit.residual)
                fit = other;
        }
        d.levels[l].fit = fit;
    }
    if (d.clipping)
        d.clipping->filtered = clipped > whole;
}

/// One factor for all levels, their median; the chain; and its law.
void fitScaleAndLaw(Work& work)
{
    Diagnosis& d = work.result;
    std::vector<double> scales;
    for (const LevelDiagnosis& level : d.levels)
        if (level.layout.size > 1 || d.levels.size() == 1)
            scales.push_back(level.fit.scale);
    std::nth_element(scales.begin(), scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2), scales.end());
    d.scale = scales[scales.size() / 2];
    if (!(d.scale > 0.0))
        d.scale = 1.0;
    std::vector<MeasuredLevel> measured;
    for (const LevelDiagnosis& level : d.levels)
        measured.push_back({std::sqrt(level.fit.alpha), std::sqrt(unresolvedAlpha(quarterTexels(level.layout)))});
    d.chain = measured.size();
    if (d.chain < 2)
        return;
    d.laws = fitLaws(measured, quarterTexels(d.levels.front().layout));
    // A last level that is the diffuse light is no part of the chain where the rest follows a law without it.
    if (!d.lawFound() && d.chain > 2 && d.levels.back().fit.alpha > 0.9) {
        measured.pop_back();
        std::vector<LawFit> without = fitLaws(measured, quarterTexels(d.levels.front().layout));
        if (without.front().error < std::min(lawTolerance, 0.5 * d.laws.front().error)) {
            d.laws = std::move(without);
            d.chain = measured.size();
        }
    }
}

void measureErrors(Work& work)
{
    Diagnosis& d = work.result;
    for (size_t l = 0; l < work.levels.size(); ++l) {
        LevelDiagnosis& level = d.levels[l];
        EnvironmentMap& map = work.levels[l];
        Lobe lobe = level.fit.lobe;
        if (d.lawFound() && l < d.chain) {
            level.asked = d.laws.front().roughness[l] * d.laws.front().roughness[l];
            if (lobe.kind == LobeKind::Ggx)
                lobe = ggxLobe(*level.asked);
            if (lobe.isMirror() && level.fit.alpha < 2.0 * unresolvedAlpha(quarterTexels(level.layout)))
                level.fit.unfiltered = true; // what is left is how the environment was brought to these texels
        }
        const EnvironmentMap truth = truthOf(*work.source, lobe, level.layout, work.options.tolerance, work.job);
        EnvironmentMap stored(level.layout, work.map.levels[l].image);
        if (d.orientation && d.kind == Parameterization::Cube)
            stored.image = inOurConvention(stored.image, d.orientation->places);
        level.storedRelRms = relRms(stored, truth);
        scaleBy(map.image, 1.0 / d.scale);
        level.mended = errorMetrics(map, truth);
        level.truthSeam = seamSteps(truth).ratio();
        const double expected = meanLuminance(truth);
        level.energy = expected > 0.0 ? meanLuminance(map) / expected : 0.0;
        level.shift = d.orientation && d.kind == Parameterization::Cube
                          ? sampleShift(asStored(map.image, d.orientation->places), asStored(truth.image, d.orientation->places), 6)
                          : sampleShift(map.image, truth.image, pictures(level.layout));
        work.job.checkStop();
    }
}

/// The map's sharp level 0 as the probe of the others.
std::optional<EnvironmentMap> ownProbe(const Work& work)
{
    if (work.levels.size() < 2 || quarterTexels(work.levels.front().layout) < 16)
        return {};
    const EnvironmentMap& first = work.levels.front();
    return reproject(first, {.target = {Parameterization::Latlong, std::min(512, latlongHeight(first.layout)), 0}}, work.job);
}

} // namespace

Diagnosis diagnose(const StoredMap& map, const std::optional<EnvironmentMap>& probe, const DiagnoseOptions& options, const JobControl& job)
{
    Work work{map, options, job};
    describeFile(work);
    Diagnosis& d = work.result;
    d.withProbe = probe.has_value();
    if (probe) {
        EnvironmentMap latlong = *FilterSource(*probe, job).latlong();
        d.orientation = findOrientation({map.layout(0), map.levels.front().image}, latlong, job);
        moveLevels(work);
        latlong = probeInPlace(latlong, *d.orientation, map.kind, job);
        work.source = FilterSource(latlong, job);
        undoCurve(work, latlong);
        findClipping(work, latlong);
        findEarlyClipping(work, latlong);
        fitLobes(work);
        fitScaleAndLaw(work);
        measureErrors(work);
    } else {
        moveLevels(work);
        if (std::optional<EnvironmentMap> own = ownProbe(work)) {
            work.source = FilterSource(std::move(*own), job);
            fitLobes(work);
            fitScaleAndLaw(work);
            d.levelZeroIsProbe = true;
            measureErrors(work);
        }
    }
    concludeDiagnosis(d);
    return d;
}

} // namespace mirrorball
