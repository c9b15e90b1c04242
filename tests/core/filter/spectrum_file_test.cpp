#include "core/filter/spectrum_file.h"

#include "core/base/error.h"
#include "core/base/file_log.h"
#include "core/filter/prefilter.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace mirrorball {
namespace {

using test::noiseProbe;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A probe of noise with a sun of four texels, as a file.
class SpectrumFile : public testing::Test {
protected:
    SpectrumFile()
    {
        for (const auto& [x, y] : {std::pair{40, 20}, {41, 20}, {40, 21}, {3, 60}})
            for (int c = 0; c < 3; ++c)
                probe.image.texel(x, y)[c] = 5000.0f;
        writeImage(file, probe.image);
    }

    SpectrumPart part(int first, int end, double threshold = 1000.0)
    {
        ProbeFile opened(file.string(), {});
        return probeSpectrum(opened, {.degree = 60, .threshold = threshold, .rows = RowRange{first, end}});
    }
    SpectrumPart stored(const SpectrumPart& from)
    {
        writeSpectrum(path, from);
        return readSpectrum(path);
    }

    TemporaryFolder folder{};
    std::filesystem::path file = folder / "probe.exr", path = folder / "part.spectrum";
    EnvironmentMap probe = noiseProbe(64, 7);
};

double largestDifference(const Spectrum& a, const Spectrum& b)
{
    double largest = 0.0;
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < a.coefficients[c].size(); ++i)
            largest = std::max(largest, std::abs(a.coefficients[c][i] - b.coefficients[c][i]));
    return largest;
}

TEST_F(SpectrumFile, PartsAddUpToTheSpectrumOfTheProbe)
{
    const SpectrumPart sum = addSpectra({stored(part(40, 64, 0.0)), stored(part(0, 7, 0.0)), stored(part(7, 40, 0.0))});
    const Spectrum whole = analyze(probe, 60);
    EXPECT_TRUE(sum.isWhole());
    EXPECT_LT(largestDifference(sum.calm, whole), 1e-9 * whole.peak);
    EXPECT_EQ(sum.calm.unit, whole.unit);
    EXPECT_EQ(sum.calm.peak, whole.peak);
    EXPECT_NEAR(sum.calm.secondMoment.g / whole.secondMoment.g, 1.0, 1e-12);
}

TEST_F(SpectrumFile, WhatIsTakenOutAndTheRestAreTheProbe)
{
    SpectrumPart whole = stored(part(0, 64));
    EXPECT_EQ(whole.bright.changes.size(), 4u);
    EXPECT_LE(whole.calm.peak, 1000.0);
    FilterSource source = filterSource(std::move(whole));
    EXPECT_LT(largestDifference(source.spectrum(60), analyze(probe, 60)), 1e-8 * 5000.0);
}

TEST_F(SpectrumFile, FiltersAsItsProbeDoesWithinTheTolerance)
{
    FilterSource source = filterSource(addSpectra({part(0, 30), part(30, 64)}));
    FilterSource whole(probe);
    for (const Lobe& lobe : {phongLobe(5), ggxLobe(0.6)}) {
        const PrefilterOptions options{.lobe = lobe, .target = {Parameterization::Cube, 16, 0}, .tolerance = 1e-3};
        PrefilterOptions exact = options;
        exact.method = Method::Reference;
        const ErrorMetrics error = errorMetrics(prefilter(source, options).map, prefilter(whole, exact).map);
        EXPECT_LE(error.relRms, 1e-3) << describe(lobe);
        EXPECT_LE(error.p99Rel, 5e-3) << describe(lobe);
    }
}

/// Made again as the message says, it holds the lobe.
TEST_F(SpectrumFile, ThatDoesNotHoldALobeSaysWhichDegreeWould)
{
    const PrefilterOptions options{.lobe = phongLobe(30), .target = {Parameterization::Cube, 16, 0}, .tolerance = 1e-4};
    const auto ofDegree = [&](int degree) {
        ProbeFile opened(file.string(), {});
        return filterSource(probeSpectrum(opened, {.degree = degree, .threshold = 1000.0}));
    };
    std::string why;
    try {
        FilterSource coarse = ofDegree(12);
        prefilter(coarse, options);
    } catch (const InvalidArgument& error) {
        why = error.what();
    }
    constexpr std::string_view remedy = "its spectrum goes to degree 12; make it again with --degree ";
    ASSERT_NE(why.find(remedy), std::string::npos) << why;
    const int degree = std::stoi(why.substr(why.find(remedy) + remedy.size()));
    EXPECT_LE(degree, 127) << "--degree takes no more of this probe";
    FilterSource fine = ofDegree(degree), whole(probe);
    PrefilterOptions exact = options;
    exact.method = Method::Reference;
    EXPECT_LE(errorMetrics(prefilter(fine, options).map, prefilter(whole, exact).map).relRms, 1e-4);
}

TEST_F(SpectrumFile, NamesTheProbeItselfForWhatNoSpectrumHolds)
{
    FilterSource source = filterSource(part(0, 64));
    const auto words = [&](const Lobe& lobe, Method method = Method::Auto) {
        try {
            prefilter(source, {.lobe = lobe, .target = {Parameterization::Cube, 8, 0}, .method = method, .tolerance = 1e-5});
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(words(phongLobe(600)), HasSubstr("no spectrum holds this lobe; allow a larger tolerance, or filter the probe itself"));
    EXPECT_THAT(words(ggxLobe(0.0)), HasSubstr("too narrow to filter"));
    EXPECT_THAT(words(phongLobe(5), Method::Direct), HasSubstr("needs the whole probe in memory; use auto or spectral"));
}

TEST_F(SpectrumFile, IsAFileThatARecipeNames)
{
    writeSpectrum(path, part(0, 64));
    const FileLog log;
    readSpectrum(path);
    ASSERT_EQ(log.read().size(), 1u);
    EXPECT_EQ(log.read().front().path, std::filesystem::absolute(path));
}

TEST_F(SpectrumFile, DoesNotDependOnTheOrderOfItsParts)
{
    const SpectrumPart a = addSpectra({part(0, 10), part(10, 33), part(33, 64)}), b = addSpectra({part(33, 64), part(0, 10), part(10, 33)});
    EXPECT_EQ(a.calm.coefficients, b.calm.coefficients);
}

TEST_F(SpectrumFile, NamesRowsThatAreMissingOrThereTwice)
{
    EXPECT_THAT(
        [&] {
            filterSource(addSpectra({part(0, 10), part(12, 64)}));
        },
        ThrowsMessage<InvalidArgument>(HasSubstr("lacks rows of its probe, the first of them 10")));
    EXPECT_THAT([&] { addSpectra({part(0, 10), part(9, 64)}); }, ThrowsMessage<InvalidArgument>(HasSubstr("two parts hold row 9")));
    EXPECT_THAT(
        [&] {
            addSpectra({part(0, 10), part(10, 64, 20.0)});
        },
        ThrowsMessage<InvalidArgument>(HasSubstr("the threshold of bright texels")));
}

TEST_F(SpectrumFile, CutOrLengthenedAnywhereIsDamaged)
{
    writeSpectrum(path, part(0, 64));
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const auto isRefused = [&](const std::string& content) {
        std::ofstream(path, std::ios::binary) << content;
        try {
            readSpectrum(path);
        } catch (const FileError&) {
            return true;
        }
        return false;
    };
    for (size_t cut = 0; cut < 60; ++cut)
        EXPECT_TRUE(isRefused(bytes.substr(0, bytes.size() * cut / 60))) << cut;
    EXPECT_TRUE(isRefused(bytes + "x"));
    std::string wrong = bytes;
    wrong.replace(wrong.find("\"degree\":60"), 11, "\"degree\":61");
    EXPECT_TRUE(isRefused(wrong));
    wrong = bytes;
    wrong.replace(wrong.size() - 8, 8, std::string("\x00\x00\x00\x00\x00\x00\xf0\x7f", 8)); // an infinity
    EXPECT_TRUE(isRefused(wrong));
    EXPECT_FALSE(isRefused(bytes));
}

} // namespace
} // namespace mirrorball
