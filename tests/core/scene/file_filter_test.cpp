#include "core/scene/file_filter.h"

#include "core/base/error.h"
#include "core/filter/spectrum_file.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

class FileFilter : public testing::Test {
protected:
    FileFilter() { writeImage(file, probe.image); }

    FileFilterOptions options(const std::string& from) const
    {
        return {.probe = from,
                .levels = {{.lobe = phongLobe(10), .target = {Parameterization::Cube, 8, 0}, .tolerance = 1e-3}},
                .file = "map.exr"};
    }

    test::TemporaryFolder folder{};
    std::filesystem::path file = folder / "probe.exr";
    EnvironmentMap probe = test::noiseProbe(32, 3);
};

TEST_F(FileFilter, IsTheFilterOfTheProbeInTheFile)
{
    const FileFilterOptions asked = options(file.string());
    PlannedFileFilter planned = planFileFilter(asked);
    EXPECT_EQ(std::get<SavesFile>(planned.plan.decisions.back().why).file, "map.exr");
    const BuiltMap built = filterFile(std::move(planned));
    FilterSource source(probe);
    EXPECT_EQ(built.levels.front().image.texels, prefilter(source, asked.levels.front()).map.image.texels);
    EXPECT_EQ(built.record.stages.front().name, "plan");
    EXPECT_FALSE(built.record.methodText().empty());
}

TEST_F(FileFilter, TakesASpectrumWhichWasReadAlready)
{
    const std::filesystem::path spectrum = folder / "whole.spectrum";
    ProbeFile opened(file.string(), {});
    writeSpectrum(spectrum, probeSpectrum(opened, {.degree = 60}));
    FileFilterOptions asked = options(spectrum.string());
    FilterSource source(probe);
    PrefilterOptions exact = asked.levels.front();
    exact.method = Method::Reference;
    const EnvironmentMap truth = prefilter(source, exact).map;
    EXPECT_LE(errorMetrics(filterFile(planFileFilter(asked)).levels.front(), truth).relRms, 1e-3);
    asked.read.reading.mirror = MirrorAxis::X;
    EXPECT_THAT([&] { planFileFilter(asked); },
                testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr("a spectrum knows how its probe was read")));
}

} // namespace
} // namespace mirrorball
