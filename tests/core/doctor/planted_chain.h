#pragma once

#include "core/doctor/diagnosis.h"
#include "core/engine/roughness_law.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// Prefiltered chains with faults planted.
namespace mirrorball::test {

/// An environment without symmetry, of which every side has its color and its letters.
inline const EnvironmentMap& axesProbe()
{
    static const EnvironmentMap probe = renderBuiltinProbe("axes", {Parameterization::Latlong, 256, 0});
    return probe;
}

struct ChainOptions {
    int size = 64;
    int levels = 5;
    std::function<Lobe(int)> lobe{}; ///< of a level
    Parameterization kind = Parameterization::Cube;
    double yaw = 0.0;
};

inline std::function<Lobe(int)> lobesOf(RoughnessLaw law, int levels, int size)
{
    return [=](int l) {
        const double r = levelRoughness(law, l, levels, size);
        return ggxLobe(r * r);
    };
}

inline std::vector<EnvironmentMap> filteredChain(const EnvironmentMap& probe, const ChainOptions& options)
{
    FilterSource source(probe);
    std::vector<EnvironmentMap> levels;
    for (int l = 0; l < options.levels; ++l)
        levels.push_back(prefilter(source, {.lobe = options.lobe(l),
                                            .target = {options.kind, std::max(1, options.size >> l), 0},
                                            .tolerance = 1e-4,
                                            .yaw = options.yaw})
                             .map);
    return levels;
}

/// Filament's chain of the axes probe: faces of 64, five levels down to 4.
inline const std::vector<EnvironmentMap>& axesChain()
{
    static const std::vector<EnvironmentMap> chain = filteredChain(axesProbe(), {.lobe = lobesOf(RoughnessLaw::Filament, 5, 64)});
    return chain;
}

inline StoredMap stored(const std::vector<EnvironmentMap>& levels)
{
    StoredMap map;
    map.container = "memory";
    map.kind = levels.front().layout.kind;
    for (const EnvironmentMap& level : levels) {
        map.levels.push_back({level.image, {}});
        map.levels.back().repaired = repair(map.levels.back().image, NegativePolicy::Keep);
    }
    return map;
}

/// Every value of every level changed.
inline std::vector<EnvironmentMap> changed(std::vector<EnvironmentMap> levels, const std::function<double(double)>& change)
{
    for (EnvironmentMap& level : levels)
        for (float& t : level.image.texels)
            t = static_cast<float>(change(t));
    return levels;
}

/// One face of a stacked cube turned.
inline void turnFace(Image& cube, int face, FaceTurn turn)
{
    const Image before = cube;
    const int n = cube.width;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const TurnedTexel from = turnedTexel(turn, n, x, y);
            std::copy_n(before.texel(from.x, face * n + from.y), 3, cube.texel(x, face * n + y));
        }
}

inline void exchangeFaces(Image& cube, int a, int b)
{
    const std::ptrdiff_t face = static_cast<std::ptrdiff_t>(cube.width) * cube.width * 3;
    std::swap_ranges(cube.texels.begin() + a * face, cube.texels.begin() + (a + 1) * face, cube.texels.begin() + b * face);
}

/// A cube stored some way: texel (f, s, t) holds L(axes G(f, turned (s, t))).
inline Image storedAs(const Image& ours, const CubeStorage& storage)
{
    const int n = ours.width;
    Image result(n, 6 * n, 3);
    for (int f = 0; f < 6; ++f)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const TurnedTexel p = turnedTexel(storage.turn, n, x, y);
                const MapLayout layout{Parameterization::Cube, n, 0};
                const glm::dvec2 at = coordinate(layout, storage.axes * texelDirection(layout, p.x, f * n + p.y));
                std::copy_n(ours.texel(static_cast<int>(at.x), static_cast<int>(at.y)), 3, result.texel(x, f * n + y));
            }
    return result;
}

inline const Finding* finding(const Diagnosis& d, const std::string& kind, Severity severity = Severity::Fault)
{
    for (const Finding& f : d.findings)
        if (f.kind == kind && f.severity == severity)
            return &f;
    return nullptr;
}

inline size_t faults(const Diagnosis& d)
{
    return static_cast<size_t>(
        std::count_if(d.findings.begin(), d.findings.end(), [](const Finding& f) { return f.severity == Severity::Fault; }));
}

} // namespace mirrorball::test
