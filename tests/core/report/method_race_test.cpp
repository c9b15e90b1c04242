#include "core/report/method_race.h"

#include "core/base/error.h"
#include "core/image/map_picture.h"

#include "support/probe_builders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

MethodRace smallRace()
{
    return MethodRace(FilterSource(test::noiseProbe(32, 3)), phongLobe(20.0), {.target = {Parameterization::Cube, 8, 0}, .repeats = 1});
}

TEST(MethodRace, MeasuresEveryMethodOrSaysWhyNot)
{
    const MethodRace race = smallRace();
    std::vector<Method> measured;
    for (const MethodSetting& setting : race.settings()) {
        const RacePoint point = race.measure(setting);
        if (point.state == MeasurementState::Measured) {
            measured.push_back(setting.method);
            ASSERT_TRUE(point.map);
            EXPECT_EQ(point.map->layout, race.options().target);
            EXPECT_GT(point.seconds, 0.0);
        } else {
            EXPECT_FALSE(point.why.empty());
        }
    }
    for (const Method method : {Method::Auto, Method::Spectral, Method::Direct, Method::Hierarchical, Method::Importance, Method::Mip})
        EXPECT_THAT(measured, testing::Contains(method)) << name(method);
}

// The spectral method reproduces the reference; its stand-in is itself at a finer tolerance.
TEST(MethodRace, FindsTheSpectralMethodWithinItsTolerance)
{
    const MethodRace race = smallRace();
    const RacePoint point = race.measure({.method = Method::Spectral, .tolerance = 1e-5});
    EXPECT_LT(point.error.relRms, 1e-5);
    EXPECT_LT(signedRange(signedError(FilterSource(test::noiseProbe(32, 3)), race.lobe(), *point.map)), 1e-4);
}

TEST(MethodRace, FrontHoldsWhatNothingBeats)
{
    const auto point = [](double seconds, double error, MeasurementState state = MeasurementState::Measured) {
        RacePoint p{.state = state, .seconds = seconds};
        p.error.relRms = error;
        return p;
    };
    EXPECT_EQ(onFront({point(1, 1e-3), point(2, 1e-2), point(3, 1e-5), point(0.5, 1e-9, MeasurementState::Refused), point(1, 1e-3)}),
              (std::vector<bool>{true, false, true, false, true}));
}

TEST(MethodRace, RefusesWhatNothingFilters)
{
    EXPECT_THROW(MethodRace(FilterSource(test::constantProbe(8)), ggxLobe(0.0), {}), InvalidArgument);
}

} // namespace
} // namespace mirrorball
