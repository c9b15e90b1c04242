#include "program.h"

#include "core/image/image_io.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::TemporaryFolder;

TEST(SpectrumCommand, PartsOfAProbeAddUpAndAreFiltered)
{
    const TemporaryFolder folder;
    const auto in = [&](const std::string& name) { return (folder / name).string(); };
    ASSERT_EQ(mirrorballRuns("convert builtin:sky -o " + in("probe.hdr") + " --to latlong --size 128").status, 0);
    const std::string common = " --degree 120 --bright 20 -o ";
    ASSERT_EQ(mirrorballRuns("spectrum " + in("probe.hdr") + " --rows 64:128" + common + in("b.spectrum")).status, 0);
    ASSERT_EQ(mirrorballRuns("spectrum " + in("probe.hdr") + " --rows 0:64" + common + in("a.spectrum")).status, 0);
    const std::string lobe = " --lobe phong --exponent 20 --to cube --size 16 --tolerance 1e-3 -o ";
    EXPECT_FAILS(mirrorballRuns("filter " + in("a.spectrum") + lobe + in("map.exr")), 2, "lacks rows of its probe, the first of them 64");
    ASSERT_EQ(mirrorballRuns("spectrum --add " + in("b.spectrum") + " " + in("a.spectrum") + " -o " + in("whole.spectrum")).status, 0);
    ASSERT_EQ(mirrorballRuns("filter " + in("whole.spectrum") + lobe + in("map.exr")).status, 0);
    ASSERT_EQ(mirrorballRuns("filter " + in("probe.hdr") + lobe + in("plain.exr") + " --method reference").status, 0);
    const Image map = readImage(in("map.exr")), plain = readImage(in("plain.exr"));
    ASSERT_EQ(map.texels.size(), plain.texels.size());
    double difference = 0.0, power = 0.0;
    for (size_t i = 0; i < map.texels.size(); ++i) {
        difference += std::pow(map.texels[i] - plain.texels[i], 2.0);
        power += std::pow(plain.texels[i], 2.0);
    }
    EXPECT_LE(std::sqrt(difference / power), 2e-3); // two maps that each keep 1e-3
}

TEST(SpectrumCommand, SaysInOneLineWhatIsWrong)
{
    const TemporaryFolder folder;
    const std::string out = " -o " + (folder / "x.spectrum").string();
    EXPECT_FAILS(mirrorballRuns("spectrum" + out), 2, "PROBE: is missing");
    EXPECT_FAILS(mirrorballRuns("spectrum builtin:sky" + out), 2, "PROBE: must be the file of a latlong");
    const std::string probe = (folder / "probe.hdr").string();
    ASSERT_EQ(mirrorballRuns("convert builtin:sky -o " + probe + " --to latlong --size 32").status, 0);
    EXPECT_FAILS(mirrorballRuns("spectrum " + probe + " --degree 64" + out), 2, "--degree: must lie in 1 to 63");
    EXPECT_FAILS(mirrorballRuns("spectrum " + probe + " --degree 20 --rows 0:33" + out), 2, "--rows: must be A:B");
    EXPECT_FAILS(mirrorballRuns("spectrum " + probe + " --degree 20 --rows 5" + out), 2, "--rows: must be A:B");
    EXPECT_FAILS(mirrorballRuns("spectrum --add " + probe + out), 2, "is no spectrum");
    EXPECT_FAILS(mirrorballRuns("spectrum " + probe + " --degree 20 -o " + (folder / "x.exr").string()), 2, "end it with .spectrum");
    EXPECT_FALSE(std::filesystem::exists(folder / "x.spectrum"));
    const std::string coarse = (folder / "coarse.spectrum").string();
    ASSERT_EQ(mirrorballRuns("spectrum " + probe + " --degree 12 -o " + coarse).status, 0);
    const std::string filter = "filter " + coarse + " --lobe phong --exponent 5 --to cube --size 8 -o " + (folder / "x.exr").string();
    EXPECT_FAILS(mirrorballRuns(filter), 2, "its spectrum goes to degree 12; make it again with --degree ");
    EXPECT_FAILS(mirrorballRuns(filter + " --mirror x"), 2, "PROBE: a spectrum knows how its probe was read");
}

} // namespace
} // namespace mirrorball
