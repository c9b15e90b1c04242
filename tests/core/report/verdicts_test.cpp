#include "core/report/conclusions.h"
#include "core/report/verdicts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

Measurement measured(Method method, double seconds, double relRms, double tolerance = 1e-5)
{
    Measurement m{.setting = {.method = method, .tolerance = tolerance, .label = "a setting"}, .ran = method, .times = {{seconds}}};
    m.error.relRms = relRms;
    return m;
}

TEST(Front, HoldsWhatNoOtherMethodBeats)
{
    std::vector<Measurement> all{measured(Method::Mip, 0.001, 1e-1),         measured(Method::Spectral, 0.01, 1e-5),
                                 measured(Method::Importance, 0.02, 1e-3),   measured(Method::Spectral, 0.02, 1e-7),
                                 measured(Method::Hierarchical, 0.005, 0.2), measured(Method::Auto, 0.0001, 1e-9),
                                 measured(Method::Reference, 100.0, 0.0)};
    markFront(all);
    const std::vector<bool> expected{true, true, false, true, false, false, false};
    for (size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(all[i].onFront, expected[i]) << i;
}

TEST(Front, LeavesOutWhatWasNotMeasured)
{
    std::vector<Measurement> all{measured(Method::Mip, 0.0, 0.0), measured(Method::Spectral, 0.01, 1e-5)};
    all[0].state = MeasurementState::Refused;
    markFront(all);
    EXPECT_FALSE(all[0].onFront);
    EXPECT_TRUE(all[1].onFront);
}

TEST(TimeForError, LiesOnTheLineBetweenTwoSettings)
{
    // Error falls as 1/sqrt(time): 1e-2 at 0.1 s, 1e-4 at 1000 s, so 1e-3 takes 10 s.
    const std::vector<Measurement> all{measured(Method::Importance, 1000.0, 1e-4), measured(Method::Importance, 0.1, 1e-2)};
    const auto between = timeForError(all, Method::Importance, 1e-3);
    ASSERT_TRUE(between);
    EXPECT_TRUE(between->reached);
    EXPECT_NEAR(between->seconds, 10.0, 1e-9);
    EXPECT_NEAR(timeForError(all, Method::Importance, 0.5)->seconds, 0.1, 1e-12); // the cheapest is accurate enough
    EXPECT_FALSE(timeForError(all, Method::Importance, 1e-5)->reached);
    EXPECT_EQ(timeForError(all, Method::Importance, 1e-5)->seconds, 1000.0);
    EXPECT_FALSE(timeForError(all, Method::Sh9, 1e-3));
}

TEST(TimeForError, PassesOverSettingsThatAreDearerAndWorse)
{
    const std::vector<Measurement> all{measured(Method::Direct, 1.0, 1e-4), measured(Method::Direct, 2.0, 1e-3),
                                       measured(Method::Direct, 4.0, 1e-5)};
    EXPECT_EQ(timeForError(all, Method::Direct, 1e-3)->seconds, 1.0);
}

ReportCase exampleCase()
{
    ReportCase c{.lobe = phongLobe(50)};
    c.measurements = {measured(Method::Reference, 600.0, 0.0),   measured(Method::Auto, 0.012, 5e-4, 1e-3),
                      measured(Method::Spectral, 0.01, 4e-4),    measured(Method::Importance, 1.0, 1e-2),
                      measured(Method::Importance, 100.0, 1e-3), measured(Method::Mip, 0.001, 0.1)};
    c.measurements[1].ran = Method::Spectral;
    return c;
}

TEST(Verdict, ComparesAutoWithTheFastestMethodThatMeetsTheTolerance)
{
    const auto v = verdict(exampleCase(), 1e-3);
    ASSERT_TRUE(v);
    EXPECT_TRUE(v->meetsTolerance());
    EXPECT_EQ(v->fastest, Method::Spectral); // mip is faster but misses
    EXPECT_NEAR(v->autoOverFastest(), 1.2, 1e-12);
    EXPECT_NEAR(*v->importanceRatio, 1e4, 1e-6);
    EXPECT_FALSE(v->importanceRatioIsBound);
    EXPECT_NEAR(*v->referenceRatio, 6e4, 1e-6);
    EXPECT_FALSE(verdict(exampleCase(), 1e-2)); // auto was not measured at that one
}

TEST(Verdict, GivesABoundWhereSamplingDidNotGetThere)
{
    ReportCase c = exampleCase();
    c.measurements.erase(c.measurements.begin() + 4);
    const auto v = verdict(c, 1e-3);
    EXPECT_TRUE(v->importanceRatioIsBound);
    EXPECT_NEAR(*v->importanceRatio, 100.0, 1e-9);
}

Report exampleReport()
{
    Report report{.threads = 2, .tolerance = 1e-3};
    report.probes = {{.name = "p.hdr"}};
    report.cases = {exampleCase()};
    report.verdicts = {*verdict(report.cases[0], 1e-3)};
    return report;
}

std::string text(const Report& report)
{
    std::string all;
    for (const std::string& sentence : conclusions(report))
        all += sentence + "\n";
    return all;
}

TEST(Conclusions, SayWhatTheFiguresSay)
{
    const std::string said = text(exampleReport());
    EXPECT_THAT(said, testing::HasSubstr("For phong:50 at rel_rms 1e-3 the fastest method is spectral (10 ms)"));
    EXPECT_THAT(
        said, testing::HasSubstr(
                  "spectral is 10000 times faster than importance sampling at equal error and 60000 times faster than the reference sum"));
    EXPECT_THAT(said, testing::HasSubstr("auto meets rel_rms 1e-3 in 1 of 1 case and is within 1.3 times the fastest"));
    EXPECT_THAT(said, testing::HasSubstr("mip (best 0.1) never reaches"));
}

TEST(Conclusions, ChangeWithTheFigures)
{
    Report report = exampleReport();
    report.cases[0].measurements[5].error.relRms = 1e-4; // now mip is right, and fastest
    report.cases[0].measurements[1].error.relRms = 5e-3; // and auto misses
    report.verdicts = {*verdict(report.cases[0], 1e-3)};
    const std::string said = text(report);
    EXPECT_THAT(said, testing::HasSubstr("the fastest method is mip (1 ms)"));
    EXPECT_THAT(said, testing::HasSubstr("auto meets rel_rms 1e-3 in 0 of 1 case"));
    EXPECT_THAT(said, testing::Not(testing::HasSubstr("never reaches")));
}

TEST(Conclusions, SayNothingOfWhatWasNotMeasured) { EXPECT_EQ(text(Report{.machine = {.cores = 2}, .threads = 2}), ""); }

TEST(Conclusions, WarnOfABusyMachine)
{
    Report report{.loadAtEnd = 9.0, .threads = 2};
    EXPECT_THAT(text(report), testing::HasSubstr("busy"));
}

} // namespace
} // namespace mirrorball
