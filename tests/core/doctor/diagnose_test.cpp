#include "planted_chain.h"

#include "core/image/color.h"
#include "core/image/mip_pyramid.h"
#include "core/sphere/cube_map.h"
#include "core/sphere/direction.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

using namespace test;

/// The one fault that was planted is named, and no other.
void expectOneFault(const Diagnosis& d, const std::string& kind, const std::string& words)
{
    const Finding* found = finding(d, kind);
    ASSERT_NE(found, nullptr) << diagnosisText(d);
    EXPECT_NE(found->text.find(words), std::string::npos) << found->text;
    EXPECT_FALSE(found->cure.empty());
    EXPECT_EQ(faults(d), 1u) << diagnosisText(d);
}

TEST(Diagnosis, FindsNoFaultInACleanChainAndNamesItsLaw)
{
    struct Case {
        RoughnessLaw law;
        int levels, size;
    };
    for (const Case& c : {Case{RoughnessLaw::Filament, 5, 64}, Case{RoughnessLaw::Babylon, 7, 64}, Case{RoughnessLaw::Linear, 7, 64},
                          Case{RoughnessLaw::PlayCanvas, 5, 64}, Case{RoughnessLaw::Unity, 6, 64}}) {
        const auto chain = filteredChain(axesProbe(), {.size = c.size, .levels = c.levels, .lobe = lobesOf(c.law, c.levels, c.size)});
        const Diagnosis d = diagnose(stored(chain), axesProbe());
        EXPECT_TRUE(d.clean()) << diagnosisText(d);
        ASSERT_TRUE(d.lawFound());
        EXPECT_EQ(d.laws.front().name, std::string(name(c.law))) << diagnosisText(d);
        EXPECT_NEAR(d.scale, 1.0, 0.005);
        ASSERT_TRUE(d.orientation && d.orientation->certain());
        EXPECT_EQ(describe(*d.orientation), "not mirrored");
        for (const LevelDiagnosis& level : d.levels) {
            const double asked = levelRoughness(c.law, static_cast<int>(&level - d.levels.data()), c.levels, c.size);
            if (asked > 0.1) {
                EXPECT_NEAR(std::sqrt(level.fit.alpha), asked, 0.02) << diagnosisText(d);
            }
            EXPECT_LT(level.mended.relRms, 0.01) << diagnosisText(d);
        }
    }
}

TEST(Diagnosis, NamesAMirrorImageAndTheEnginesThatTakeIt)
{
    const auto withStorage = [](const CubeStorage& storage) {
        std::vector<EnvironmentMap> chain = axesChain();
        for (EnvironmentMap& level : chain)
            level.image = storedAs(level.image, storage);
        return diagnose(stored(chain), axesProbe());
    };
    const glm::dmat3 mirror(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    const Diagnosis mirrored = withStorage({mirror, 0, {}});
    EXPECT_TRUE(mirrored.clean()) << diagnosisText(mirrored);
    EXPECT_EQ(describe(*mirrored.orientation), "mirrored in X");
    EXPECT_EQ(mirrored.engines, std::vector<std::string>{"three.js"});
    EXPECT_EQ(diagnose(stored(axesChain()), axesProbe()).engines, std::vector<std::string>{"Filament"});

    const Diagnosis bottomUp = withStorage({mirror, rowsBottomUp, {}});
    EXPECT_EQ(describe(*bottomUp.orientation), "mirrored in X, rows bottom up");
    EXPECT_TRUE(bottomUp.clean()) << diagnosisText(bottomUp);
    expectOneFault(withStorage({glm::dmat3(1.0), rowsBottomUp, {}}), "orientation", "upside down");
    // +Z up: (x, y, z) of the map shows (x, z, -y)
    expectOneFault(withStorage({glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0), 0, {}}), "orientation", "axes are exchanged");
}

TEST(Diagnosis, NamesTheYaw)
{
    for (const double degrees : {90.0, 180.0, -90.0, 37.0}) {
        const auto chain = filteredChain(axesProbe(), {.lobe = lobesOf(RoughnessLaw::Filament, 5, 64), .yaw = degrees * pi / 180.0});
        const Diagnosis d = diagnose(stored(chain), axesProbe());
        EXPECT_NEAR(std::abs(std::remainder(d.orientation->yaw * 180.0 / pi - degrees, 360.0)), 0.0, 0.3) << diagnosisText(d);
        EXPECT_FALSE(d.orientation->mirrored());
        expectOneFault(d, "yaw", "turned by");
    }
}

TEST(Diagnosis, NamesEachFaceThatIsTurnedOrExchanged)
{
    const StoredMap clean = stored({axesChain().front(), axesChain()[2]});
    for (int face = 0; face < 6; ++face)
        for (const FaceTurn turn : {1, 2, 3, 4, 5, 6, 7}) {
            StoredMap map = clean;
            for (StoredLevel& level : map.levels)
                turnFace(level.image, face, turn);
            const Orientation o = findOrientation({map.layout(0), map.levels[0].image}, axesProbe());
            EXPECT_EQ(o.strayFaces, std::vector<int>{face}) << faceName(face) << " " << describeTurn(turn) << ": " << describe(o);
            EXPECT_EQ(o.places[static_cast<size_t>(face)], (FacePlace{face, turn}));
        }
    for (int a = 0; a < 6; ++a)
        for (int b = a + 1; b < 6; ++b) {
            StoredMap map = clean;
            for (StoredLevel& level : map.levels)
                exchangeFaces(level.image, a, b);
            const Orientation o = findOrientation({map.layout(0), map.levels[0].image}, axesProbe());
            EXPECT_EQ(o.strayFaces, (std::vector<int>{a, b})) << describe(o);
        }
    StoredMap map = stored(axesChain());
    for (StoredLevel& level : map.levels)
        turnFace(level.image, 2, 1);
    expectOneFault(diagnose(map, axesProbe()), "face", "Face 2 (+Y) is turned 90 degrees clockwise");
    map = stored(axesChain());
    for (StoredLevel& level : map.levels)
        exchangeFaces(level.image, 0, 1);
    const Diagnosis d = diagnose(map, axesProbe());
    EXPECT_EQ(faults(d), 2u) << diagnosisText(d);
    ASSERT_NE(finding(d, "face"), nullptr);
    EXPECT_NE(finding(d, "face")->text.find("shows what belongs into face 1 (-X)"), std::string::npos) << finding(d, "face")->text;
}

TEST(Diagnosis, NamesFactors)
{
    expectOneFault(diagnose(stored(changed(axesChain(), [](double v) { return pi * v; })), axesProbe()), "scale", "that is pi");
    expectOneFault(diagnose(stored(changed(axesChain(), [](double v) { return v / pi; })), axesProbe()), "scale", "1/pi");
    expectOneFault(diagnose(stored(changed(axesChain(), [](double v) { return 4.0 * v; })), axesProbe()), "scale", "+2.00 stops");
}

TEST(Diagnosis, NamesCurves)
{
    expectOneFault(diagnose(stored(changed(axesChain(), [](double v) { return transferred(v, Transfer::SrgbEncoded); })), axesProbe()),
                   "curve", "sRGB-encoded");
    expectOneFault(diagnose(stored(changed(axesChain(), [](double v) { return transferred(v, Transfer::SrgbDecoded); })), axesProbe()),
                   "curve", "decoded from sRGB once too often");
    const Diagnosis filmic =
        diagnose(stored(changed(axesChain(), [](double v) { return transferred(v, Transfer::FilmicSrgb); })), axesProbe());
    ASSERT_NE(finding(filmic, "curve"), nullptr) << diagnosisText(filmic);
    EXPECT_NE(finding(filmic, "curve")->text.find("filmic curve and sRGB"), std::string::npos) << diagnosisText(filmic);

    // A source that was decoded twice, then filtered rightly.
    EnvironmentMap dark = axesProbe();
    for (float& t : dark.image.texels)
        t = static_cast<float>(transferred(t, Transfer::SrgbDecoded));
    const auto chain = filteredChain(dark, {.lobe = lobesOf(RoughnessLaw::Filament, 5, 64)});
    const Diagnosis before = diagnose(stored(chain), axesProbe());
    EXPECT_TRUE(before.curveBeforeFiltering) << diagnosisText(before);
    expectOneFault(before, "curve", "before the levels were filtered");
}

/// Levels read at directions of their own, from filtered maps that are fine enough.
std::vector<EnvironmentMap> resampledChain(const std::function<double(int i, int n)>& place)
{
    std::vector<EnvironmentMap> levels;
    FilterSource source(axesProbe());
    for (int l = 0; l < 4; ++l) {
        const double r = levelRoughness(RoughnessLaw::Filament, l, 4, 64);
        const EnvironmentMap fine = prefilter(source, {.lobe = ggxLobe(r * r), .target = {Parameterization::Latlong, 256, 0}}).map;
        EnvironmentMap level({Parameterization::Cube, 64 >> l, 0});
        const int n = level.layout.size;
        for (int y = 0; y < 6 * n; ++y)
            for (int x = 0; x < n; ++x) {
                const glm::vec3 value = fine.radiance(cube_map::facePoint(y / n, place(x, n), place(y % n, n)));
                std::copy_n(&value.x, 3, level.image.texel(x, y));
            }
        levels.push_back(level);
    }
    return levels;
}

TEST(Diagnosis, NamesSamplesAtCornersAndOnEdges)
{
    const Diagnosis right = diagnose(stored(resampledChain([](int i, int n) { return (2.0 * i + 1.0) / n - 1.0; })), axesProbe());
    EXPECT_TRUE(right.clean()) << diagnosisText(right);
    expectOneFault(diagnose(stored(resampledChain([](int i, int n) { return 2.0 * i / n - 1.0; })), axesProbe()), "shift",
                   "half a texel off");
    expectOneFault(diagnose(stored(resampledChain([](int i, int n) { return 2.0 * i / (n - 1.0) - 1.0; })), axesProbe()), "shift",
                   "edge-sampled");
}

TEST(Diagnosis, TellsASunClippedInWhatIsStoredFromOneClippedBeforeFiltering)
{
    const EnvironmentMap probe = renderBuiltinProbe("sky", {Parameterization::Latlong, 256, 0});
    const auto lobes = lobesOf(RoughnessLaw::Filament, 5, 64);
    const Diagnosis whole = diagnose(stored(filteredChain(probe, {.lobe = lobes})), probe);
    EXPECT_TRUE(whole.clean()) << diagnosisText(whole);
    EXPECT_FALSE(whole.clipping.has_value());

    const auto clip = [](double v) { return std::min(v, 64.0); };
    const Diagnosis after = diagnose(stored(changed(filteredChain(probe, {.lobe = lobes}), clip)), probe);
    ASSERT_TRUE(after.clipping.has_value()) << diagnosisText(after);
    EXPECT_NEAR(after.clipping->value, 64.0, 1e-3);

    EnvironmentMap clipped = probe;
    for (float& t : clipped.image.texels)
        t = std::min(t, 64.0f);
    const Diagnosis before = diagnose(stored(filteredChain(clipped, {.lobe = lobes})), probe);
    ASSERT_TRUE(before.clipping.has_value()) << diagnosisText(before);
    EXPECT_TRUE(before.clipping->filtered) << diagnosisText(before);
    ASSERT_NE(finding(before, "clipped"), nullptr);
    EXPECT_NE(finding(before, "clipped")->text.find("filtered from the clipped"), std::string::npos);
}

TEST(Diagnosis, NamesLevelsInTheWrongOrder)
{
    constexpr std::array order{0, 1, 3, 2, 4};
    const auto right = lobesOf(RoughnessLaw::Filament, 5, 64);
    const auto chain = filteredChain(axesProbe(), {.lobe = [&](int l) { return right(order[static_cast<size_t>(l)]); }});
    expectOneFault(diagnose(stored(chain), axesProbe()), "order", "level 3 is sharper");

    std::vector<EnvironmentMap> reversed = axesChain();
    std::reverse(reversed.begin(), reversed.end());
    const Diagnosis d = diagnose(stored(reversed), axesProbe());
    ASSERT_NE(finding(d, "order"), nullptr) << diagnosisText(d);
    EXPECT_NE(finding(d, "order")->text.find("not the largest"), std::string::npos);
}

TEST(Diagnosis, TellsPlainMipsAndPhongLobesFromAGgxChain)
{
    std::vector<EnvironmentMap> mips = buildMipPyramid(axesChain().front()).levels;
    mips.resize(5);
    const Diagnosis plain = diagnose(stored(mips), axesProbe());
    const Finding* law = finding(plain, "law", Severity::Note);
    ASSERT_NE(law, nullptr) << diagnosisText(plain);
    EXPECT_NE(law->text.find("plain halvings"), std::string::npos) << law->text;

    const auto phong = filteredChain(axesProbe(), {.levels = 4, .lobe = [](int l) { return phongLobe(std::exp2(10 - 2 * l)); }});
    const Diagnosis d = diagnose(stored(phong), axesProbe());
    for (size_t l = 1; l < 4; ++l) {
        EXPECT_EQ(d.levels[l].fit.lobe.kind, LobeKind::Phong) << diagnosisText(d);
        EXPECT_NEAR(std::log2(d.levels[l].fit.phongExponent), 10.0 - 2.0 * static_cast<double>(l), 0.1);
    }
}

TEST(Diagnosis, ReadsLatlongs)
{
    const auto chain = filteredChain(axesProbe(), {.lobe = lobesOf(RoughnessLaw::Filament, 5, 64), .kind = Parameterization::Latlong});
    const Diagnosis d = diagnose(stored(chain), axesProbe());
    EXPECT_TRUE(d.clean()) << diagnosisText(d);
    EXPECT_EQ(d.laws.front().name, "filament");

    std::vector<EnvironmentMap> mirrored = chain;
    for (EnvironmentMap& level : mirrored)
        for (int y = 0; y < level.image.height; ++y)
            for (int x = 0; x < level.image.width / 2; ++x)
                std::swap_ranges(level.image.texel(x, y), level.image.texel(x, y) + 3, level.image.texel(level.image.width - 1 - x, y));
    EXPECT_EQ(describe(*diagnose(stored(mirrored), axesProbe()).orientation), "mirrored in X");
    expectOneFault(
        diagnose(stored(filteredChain(
                     axesProbe(), {.lobe = lobesOf(RoughnessLaw::Filament, 5, 64), .kind = Parameterization::Latlong, .yaw = -0.5 * pi})),
                 axesProbe()),
        "yaw", "-90 degrees");
}

TEST(Diagnosis, FindsTheLawWithoutAProbe)
{
    for (const RoughnessLaw law : {RoughnessLaw::Filament, RoughnessLaw::Linear}) {
        const auto chain = filteredChain(axesProbe(), {.lobe = lobesOf(law, 5, 64)});
        const Diagnosis d = diagnose(stored(chain), {});
        EXPECT_TRUE(d.levelZeroIsProbe);
        EXPECT_TRUE(d.clean()) << diagnosisText(d);
        ASSERT_TRUE(d.lawFound()) << diagnosisText(d);
        EXPECT_EQ(d.laws.front().name, std::string(name(law)));
    }
    StoredMap turned = stored(axesChain());
    for (StoredLevel& level : turned.levels)
        turnFace(level.image, 4, 1);
    const Diagnosis d = diagnose(turned, {});
    EXPECT_NE(finding(d, "seam"), nullptr) << diagnosisText(d);
}

TEST(Diagnosis, SaysThatAConstantEnvironmentTellsNoOrientation)
{
    const EnvironmentMap gray = constantProbe(64);
    const Diagnosis d =
        diagnose(stored(filteredChain(gray, {.size = 16, .levels = 3, .lobe = lobesOf(RoughnessLaw::Filament, 3, 16)})), gray);
    ASSERT_NE(finding(d, "orientation", Severity::Note), nullptr) << diagnosisText(d);
    EXPECT_FALSE(d.orientation->certain());
}

TEST(Diagnosis, FindsNoFaultInADiffuseMapAlone)
{
    for (const char* probe : {"axes", "studio"}) {
        const EnvironmentMap source = renderBuiltinProbe(probe, {Parameterization::Latlong, 128, 0});
        const auto diffuse = filteredChain(source, {.size = 32, .levels = 1, .lobe = [](int) { return diffuseLobe(); }});
        const Diagnosis d = diagnose(stored(diffuse), source);
        EXPECT_TRUE(d.clean()) << diagnosisText(d);
        EXPECT_GT(d.levels.front().fit.alpha, 0.97);
    }
}

TEST(Diagnosis, NamesValuesThatAreNoNumbers)
{
    std::vector<EnvironmentMap> chain = axesChain();
    chain[1].image.texel(3, 3)[0] = std::numeric_limits<float>::quiet_NaN();
    chain[1].image.texel(5, 3)[1] = std::numeric_limits<float>::infinity();
    const Diagnosis d = diagnose(stored(chain), axesProbe());
    EXPECT_NE(finding(d, "nan"), nullptr);
    EXPECT_NE(finding(d, "infinite"), nullptr);
}

} // namespace
} // namespace mirrorball
