#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>

#include <random>

namespace mirrorball {
namespace {

/// The promise of the spectral method on real probes: rel_rms and p99_rel against the reference sum. The reference is summed at
/// texels drawn at random and at those around the brightest place, which carry most of the root mean square.
TEST(RealProbes, AreFilteredWithinTheTolerance)
{
    const MapLayout cube{Parameterization::Cube, 128, 0};
    struct Case {
        Lobe lobe;
        double relRms, p99Rel;
    };
    const std::vector<Case> cases{{phongLobe(1), 1e-5, 1e-3},   {phongLobe(10), 1e-5, 1e-3},   {phongLobe(50), 1e-5, 1e-3},
                                  {phongLobe(500), 1e-5, 1e-3}, {phongLobe(5000), 1e-5, 1e-3}, {diffuseLobe(), 1e-5, 1e-3},
                                  {ggxLobe(0.01), 1e-4, 1.0},   {ggxLobe(0.09), 1e-4, 1.0},    {ggxLobe(0.36), 1e-4, 1.0},
                                  {ggxLobe(1.0), 1e-4, 1.0}};
    std::mt19937 generator(1);
    for (const auto& path : test::realProbes()) {
        Image image = readImage(path);
        const EnvironmentMap probe({Parameterization::Latlong, image.height, 0}, std::move(image));
        FilterSource source(probe);
        for (const Case& c : cases) {
            if (isUnresolved(c.lobe, probe.layout.width()))
                continue; // a lookup, which is not compared with sums
            const EnvironmentMap map = prefilter(source, {.lobe = c.lobe, .target = cube}).map;
            std::vector<int> texels;
            for (int i = 0; i < 50; ++i)
                texels.push_back(static_cast<int>(generator() % (128u * 768u)));
            int brightest = 0;
            for (int i = 0; i < 128 * 768; ++i)
                if (map.image.texels[3 * static_cast<size_t>(i)] > map.image.texels[3 * static_cast<size_t>(brightest)])
                    brightest = i;
            for (const int offset : {0, 1, 3, 128, 384})
                texels.push_back(std::min(brightest + offset, 128 * 768 - 1));
            std::vector<glm::dvec3> values, directions;
            for (const int i : texels) {
                const float* t = map.image.texel(i % 128, i / 128);
                values.emplace_back(t[0], t[1], t[2]);
                directions.push_back(texelDirection(cube, i % 128, i / 128));
            }
            const ErrorMetrics e = errorMetrics(values, referenceSum(probe, c.lobe, directions));
            EXPECT_LE(e.relRms, c.relRms) << path.filename() << ' ' << describe(c.lobe);
            EXPECT_LE(e.p99Rel, c.p99Rel) << path.filename() << ' ' << describe(c.lobe);
        }
    }
}

} // namespace
} // namespace mirrorball
