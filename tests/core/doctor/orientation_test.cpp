#include "planted_chain.h"

#include <gtest/gtest.h>

#include <set>

namespace mirrorball {
namespace {

using namespace test;

TEST(Orientation, KnowsEveryWayOfStoringACubeOnce)
{
    std::set<std::vector<int>> seen;
    for (const CubeStorage& storage : allCubeStorages()) {
        std::vector<int> places;
        for (const FacePlace& place : storage.places) {
            places.push_back(place.face);
            places.push_back(place.turn);
        }
        seen.insert(places);
    }
    EXPECT_EQ(allCubeStorages().size(), 48u * 8u);
    EXPECT_EQ(seen.size(), 48u * 8u);
}

TEST(Orientation, NamesEveryWayOfStoringACube)
{
    const Image ours = axesChain().front().image;
    for (size_t i = 0; i < allCubeStorages().size(); i += 7) { // 7 has no factor in common with 8 and 48: every turn, most axes
        const CubeStorage& storage = allCubeStorages()[i];
        const EnvironmentMap map({Parameterization::Cube, ours.width, 0}, storedAs(ours, storage));
        const Orientation o = findOrientation(map, axesProbe());
        EXPECT_EQ(o.places, storage.places) << i << ": " << describe(o);
        EXPECT_TRUE(o.certain());
        // Odd turns of all faces may also be told as faces exchanged in another storage; usual ones are told as they are.
        if (storage.turn == 0 || (storage.turn == rowsBottomUp && storage.axes[1] == glm::dvec3(0, 1, 0))) {
            EXPECT_TRUE(o.strayFaces.empty()) << i << ": " << describe(o);
            EXPECT_EQ(o.mirrored(), glm::determinant(storage.axes) < 0.0);
        }
        EXPECT_EQ(inOurConvention(map.image, o.places), ours);
    }
}

TEST(Orientation, TurnsPicturesClockwise)
{
    // One texel at the top left goes to the top right.
    const TurnedTexel from = turnedTexel(1, 4, 3, 0);
    EXPECT_EQ(from.x, 0);
    EXPECT_EQ(from.y, 0);
    EXPECT_EQ(turnedTexel(columnsMirrored, 4, 0, 2).x, 3);
    EXPECT_EQ(turnedTexel(rowsBottomUp, 4, 1, 0).y, 3);
    EXPECT_EQ(turnedTexel(rowsBottomUp, 4, 1, 0).x, 1);
}

TEST(DegreeParts, AddUpToTheEnvironment)
{
    // A band-limited environment: the probe through a wide lobe. Its parts, each with the lobe's factor, are the filtered map.
    const Spectrum spectrum = analyze(axesProbe(), 48);
    const std::vector<double> k = legendreCoefficients(phongLobe(20.0), 48);
    FilterSource source(axesProbe());
    const EnvironmentMap filtered =
        prefilter(source, {.lobe = phongLobe(20.0), .target = {Parameterization::Cube, 4, 0}, .method = Method::Reference}).map;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 4; ++x) {
            const std::vector<glm::dvec3> parts = degreeParts(spectrum, texelDirection(filtered.layout, x, y), 48);
            glm::dvec3 sum(0.0);
            for (size_t l = 0; l < parts.size(); ++l)
                sum += k[l] * parts[l];
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(sum[c], filtered.image.texel(x, y)[c], 2e-4);
        }
}

} // namespace
} // namespace mirrorball
