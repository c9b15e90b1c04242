#include "orientation.h"

#include "core/filter/prefilter.h"
#include "core/image/color.h"
#include "core/image/reproject.h"
#include "core/sphere/cube_map.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace mirrorball {

namespace {

constexpr int largestFace = 16; ///< texels that faces are compared at

/// Six faces of logarithms of luminance.
struct Faces {
    int n = 0;
    std::vector<double> values{}; ///< 6 n n

    double at(int face, int x, int y) const { return values[static_cast<size_t>((face * n + y) * n + x)]; }
};

double luminanceOf(const float* t) { return luminance({t[0], t[1], t[2]}); }

/// Logarithms, shifted and scaled to mean 0 and variance 1: what a scale and a gamma leave as it is. Dark texels count from a hundredth of
/// the mean on. A constant map becomes 0.
void normalize(std::vector<double>& values)
{
    const auto n = static_cast<double>(values.size());
    std::vector<double> sorted = values;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double floor = 0.01 * std::max(sorted[sorted.size() / 2], 1e-30);
    for (double& v : values)
        v = std::log(std::max(v, 0.0) + floor);
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double power = 0.0;
    for (double& v : values) {
        v -= mean;
        power += v * v;
    }
    const double scale = power > 1e-9 * n ? 1.0 / std::sqrt(power / n) : 0.0;
    for (double& v : values)
        v *= scale;
}

/// Faces as they are stored, averaged to at most `largestFace` texels.
Faces storedFaces(const Image& cube)
{
    const int from = cube.width;
    Faces faces{std::min(from, largestFace), {}};
    const int n = faces.n;
    faces.values.resize(static_cast<size_t>(6 * n * n));
    std::vector<int> counts(faces.values.size());
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < from; ++y)
            for (int x = 0; x < from; ++x) {
                const auto i = static_cast<size_t>((face * n + y * n / from) * n + x * n / from);
                faces.values[i] += luminanceOf(cube.texel(x, face * from + y));
                ++counts[i];
            }
    for (size_t i = 0; i < faces.values.size(); ++i)
        faces.values[i] /= counts[i];
    normalize(faces.values);
    return faces;
}

/// The faces of a latlong, turned by `yaw`: means over their texels, as those that are stored are, so that a sun of one texel counts the
/// same in both.
Faces facesOf(const EnvironmentMap& latlong, int n, double yaw)
{
    const EnvironmentMap cube = reproject(latlong, {.target = {Parameterization::Cube, n, 0}, .yaw = yaw}, {.threads = 1});
    Faces faces{n, {}};
    for (size_t i = 0; i < cube.image.texels.size(); i += 3)
        faces.values.push_back(luminanceOf(&cube.image.texels[i]));
    normalize(faces.values);
    return faces;
}

/// Mean squared difference of every stored face to every face of the environment in every turn: 2 for unrelated pictures.
using Costs = std::array<std::array<std::array<double, allFaceTurns>, 6>, 6>;

Costs faceCosts(const Faces& stored, const Faces& truth)
{
    Costs costs{};
    const int n = stored.n;
    std::vector<double> turned(static_cast<size_t>(n * n));
    for (size_t j = 0; j < 6; ++j)
        for (FaceTurn turn = 0; turn < allFaceTurns; ++turn) {
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const TurnedTexel from = turnedTexel(turn, n, x, y);
                    turned[static_cast<size_t>(y * n + x)] = truth.at(static_cast<int>(j), from.x, from.y);
                }
            for (size_t i = 0; i < 6; ++i) {
                double sum = 0.0;
                const double* values = stored.values.data() + i * turned.size();
                for (size_t k = 0; k < turned.size(); ++k)
                    sum += (values[k] - turned[k]) * (values[k] - turned[k]);
                costs[i][j][static_cast<size_t>(turn)] = sum / static_cast<double>(turned.size());
            }
        }
    return costs;
}

double costOf(const Costs& costs, size_t i, const FacePlace& place)
{
    return costs[i][static_cast<size_t>(place.face)][static_cast<size_t>(place.turn)];
}

double costOf(const Costs& costs, const FacePlaces& places)
{
    double sum = 0.0;
    for (size_t i = 0; i < 6; ++i)
        sum += costOf(costs, i, places[i]);
    return sum / 6.0;
}

struct Best {
    const CubeStorage* storage = nullptr;
    double cost = std::numeric_limits<double>::infinity();
};

/// The best whole storage. @param turns  1: faces are not turned in themselves, as in maps that are no cubes
Best bestStorage(const Costs& costs, FaceTurn turns)
{
    Best best;
    for (const CubeStorage& storage : allCubeStorages()) {
        if (storage.turn >= turns)
            continue;
        const double cost = costOf(costs, storage.places);
        if (cost < best.cost - 1e-9) {
            best.storage = &storage;
            best.cost = cost;
        }
    }
    return best;
}

/// The best exchange and turns of single faces, each face used once.
FacePlaces bestPlaces(const Costs& costs)
{
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};
    FacePlaces best{};
    double least = std::numeric_limits<double>::infinity();
    do {
        FacePlaces places{};
        for (size_t i = 0; i < 6; ++i) {
            const auto& row = costs[i][static_cast<size_t>(order[i])];
            places[i] = {order[i], static_cast<FaceTurn>(std::min_element(row.begin(), row.end()) - row.begin())};
        }
        const double cost = costOf(costs, places);
        if (cost < least) {
            least = cost;
            best = places;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

/// Whether a stored face clearly shows something else than a storage has there: what a picture's own contrast, `variance`, tells.
bool strays(const Costs& costs, const std::array<double, 6>& variance, size_t i, const FacePlace& follows, const FacePlace& free)
{
    if (follows == free)
        return false;
    const double is = costOf(costs, i, free), should = costOf(costs, i, follows);
    return is < 0.5 * should && should - is > 0.1 * variance[i] && should - is > 1e-3;
}

/// How far-fetched a storage is, counted in stray faces. The same pictures may be told in several ways: +X and -X exchanged are a cube
/// mirrored in X whose faces are all mirrored left to right.
double oddity(const CubeStorage& storage)
{
    const bool upright = storage.axes[1] == glm::dvec3(0.0, 1.0, 0.0);
    const double turn = storage.turn == 0 ? 0.0 : storage.turn == rowsBottomUp ? 0.5 : 2.2;
    return turn + (upright ? 0.0 : 1.8) + (glm::determinant(storage.axes) < 0.0 ? 0.4 : 0.0);
}

/// The plainest whole storage from which few faces stray; among those the cheapest.
const CubeStorage& nearestStorage(const Costs& costs, const std::array<double, 6>& variance, const FacePlaces& places)
{
    const CubeStorage* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const CubeStorage& storage : allCubeStorages()) {
        double cost = 1e-3 * costOf(costs, storage.places) + oddity(storage);
        for (size_t i = 0; i < 6; ++i)
            cost += strays(costs, variance, i, storage.places[i], places[i]) ? 1.0 : 0.0;
        if (cost < least - 1e-9) {
            least = cost;
            nearest = &storage;
        }
    }
    return *nearest;
}

std::array<double, 6> faceVariances(const Faces& faces)
{
    std::array<double, 6> variances{};
    const size_t count = faces.values.size() / 6;
    for (size_t f = 0; f < 6; ++f) {
        double sum = 0.0, power = 0.0;
        for (size_t k = 0; k < count; ++k) {
            const double v = faces.values[f * count + k];
            sum += v;
            power += v * v;
        }
        const auto n = static_cast<double>(count);
        variances[f] = power / n - sum / n * (sum / n);
    }
    return variances;
}

/// The sharpness that the map may have: the probe as it is, and through lobes.
constexpr std::array probeAlphas{0.0, 0.1, 0.35, 1.0};

std::vector<EnvironmentMap> blurredProbes(const EnvironmentMap& probe, const JobControl& job)
{
    const MapLayout small{Parameterization::Latlong, std::min(64, probe.layout.size), 0};
    std::vector<EnvironmentMap> result{reproject(probe, {.target = small}, job)};
    FilterSource source(probe, job);
    for (const double alpha : std::span(probeAlphas).subspan(1)) {
        const PrefilterOptions options{.lobe = ggxLobe(alpha), .target = small, .method = Method::Spectral, .tolerance = 3e-3};
        result.push_back(prefilter(source, options, job).map);
    }
    return result;
}

/// What a search goes over.
struct Search {
    Faces stored{};
    std::vector<EnvironmentMap> probes{};
    FaceTurn turns = allFaceTurns;

    Costs costs(size_t probe, double yaw) const { return faceCosts(stored, facesOf(probes[probe], stored.n, yaw)); }
};

struct Candidate {
    size_t probe = 0;
    double yaw = 0.0;
    double cost = std::numeric_limits<double>::infinity();
};

/// The yaw between two quarter turns, by whole storages.
Candidate searchYaw(const Search& search)
{
    Candidate best;
    const auto consider = [&](size_t probe, double yaw) {
        const double cost = bestStorage(search.costs(probe, yaw), search.turns).cost;
        if (cost < best.cost)
            best = {probe, yaw, cost};
    };
    constexpr int steps = 24; // of 3.75 degrees
    for (size_t probe = 0; probe < search.probes.size(); ++probe)
        for (int i = 0; i < steps; ++i)
            consider(probe, 0.5 * pi * i / steps);
    for (double step = 0.25 * pi / steps; step > 1e-4; step *= 0.5) {
        const Candidate center = best;
        consider(center.probe, center.yaw - step);
        consider(center.probe, center.yaw + step);
    }
    return best;
}

/// The yaw as an angle of its own: quarter turns of the storage about +Y become part of it where the storage is our own or its mirror
/// image.
void foldQuarterTurns(Orientation& found)
{
    const glm::dmat3 mirror(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    for (int quarter = 0; quarter < 4; ++quarter)
        for (const bool mirrored : {false, true}) {
            glm::dmat3 axes(1.0);
            for (int c = 0; c < 3; ++c) { // stored e shows L(yawed(e', -q)), e' mirrored or not
                glm::dvec3 e(0.0);
                e[c] = 1.0;
                axes[c] = glm::round(yawed(mirrored ? mirror * e : e, -0.5 * pi * quarter));
            }
            if (axes != found.storage.axes)
                continue;
            found.yaw = std::remainder(found.yaw + 0.5 * pi * quarter, 2.0 * pi);
            found.storage.axes = mirrored ? mirror : glm::dmat3(1.0);
            return;
        }
}

} // namespace

Orientation findOrientation(const EnvironmentMap& stored, const EnvironmentMap& probe, const JobControl& job)
{
    const bool cube = stored.layout.kind == Parameterization::Cube;
    Search search;
    search.turns = cube ? allFaceTurns : 1;
    search.stored = storedFaces(
        cube ? stored.image
             : reproject(stored, {.target = {Parameterization::Cube, std::clamp(stored.layout.size / 2, 2, largestFace), 0}}).image);
    search.probes = blurredProbes(probe, job);

    // First as it is, with single faces free; any other yaw only where that does not fit.
    Candidate best;
    for (size_t i = 0; i < search.probes.size(); ++i) {
        const Costs costs = search.costs(i, 0.0);
        if (const double cost = cube ? costOf(costs, bestPlaces(costs)) : bestStorage(costs, search.turns).cost; cost < best.cost)
            best = {i, 0.0, cost};
    }
    if (best.cost > 0.1)
        if (const Candidate turned = searchYaw(search); turned.cost < 0.6 * best.cost || turned.cost < best.cost - 0.05)
            best = turned;

    const Costs costs = search.costs(best.probe, best.yaw);
    const Best whole = bestStorage(costs, search.turns);
    Orientation found;
    found.storage = *whole.storage;
    found.places = whole.storage->places;
    found.yaw = found.restYaw = best.yaw;
    found.alpha = probeAlphas[best.probe];
    if (cube) {
        const FacePlaces free = bestPlaces(costs);
        const std::array<double, 6> variance = faceVariances(search.stored);
        found.storage = nearestStorage(costs, variance, free);
        for (size_t i = 0; i < 6; ++i) {
            const FacePlace& follows = found.storage.places[i];
            const bool stray = strays(costs, variance, i, follows, free[i]);
            found.places[i] = stray ? free[i] : follows;
            if (stray)
                found.strayFaces.push_back(static_cast<int>(i));
        }
    }
    found.match = 1.0 - 0.5 * costOf(costs, found.places);
    double next = std::numeric_limits<double>::infinity();
    for (const CubeStorage& storage : allCubeStorages())
        if (storage.turn < search.turns && storage.places != found.places)
            next = std::min(next, costOf(costs, storage.places));
    found.nextMatch = 1.0 - 0.5 * next;
    foldQuarterTurns(found);
    return found;
}

Image inOurConvention(const Image& stored, const FacePlaces& places)
{
    const int n = stored.width;
    Image ours(n, 6 * n, 3);
    for (int i = 0; i < 6; ++i)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const FacePlace& place = places[static_cast<size_t>(i)];
                const TurnedTexel to = turnedTexel(place.turn, n, x, y);
                std::copy_n(stored.texel(x, i * n + y), 3, ours.texel(to.x, place.face * n + to.y));
            }
    return ours;
}

} // namespace mirrorball
