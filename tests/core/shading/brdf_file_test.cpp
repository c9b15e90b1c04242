#include "core/shading/brdf_file.h"

#include "core/shading/brdf.h"
#include "core/shading/reflection_kernel.h"

#include "core/base/error.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <random>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

void write(const std::filesystem::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// The MERL layout filled from GGX, each cell with the value at its center; `holes` of them, spread evenly, marked as missing.
std::string merlBytes(const GgxBrdf& model, size_t holes)
{
    std::string bytes;
    const std::int32_t steps[3] = {90, 90, 180};
    bytes.append(reinterpret_cast<const char*>(steps), 12);
    const double scales[3] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
    const size_t cells = 90 * 90 * 180;
    std::vector<double> channel(cells);
    for (const double scale : scales) {
        for (int h = 0; h < 90; ++h)
            for (int d = 0; d < 90; ++d)
                for (int p = 0; p < 180; ++p) {
                    const double thetaH = pi / 2 * std::pow((h + 0.5) / 90, 2.0), thetaD = pi / 2 * (d + 0.5) / 90,
                                 phi = pi * (p + 0.5) / 180;
                    // In the frame of h: n leans to -x.
                    const glm::dvec3 n(-std::sin(thetaH), 0.0, std::cos(thetaH));
                    const glm::dvec3 l(std::sin(thetaD) * std::cos(phi), std::sin(thetaD) * std::sin(phi), std::cos(thetaD));
                    const glm::dvec3 v(-l.x, -l.y, l.z);
                    const double nl = glm::dot(n, l), nv = glm::dot(n, v);
                    channel[static_cast<size_t>((h * 90 + d) * 180 + p)] =
                        nl > 0.0 && nv > 0.0 ? model.value(nl, nv, glm::dot(l, v)) / scale : -1.0;
                }
        for (size_t i = 0; i < holes; ++i)
            channel[i * (cells / holes)] = -1.0;
        bytes.append(reinterpret_cast<const char*>(channel.data()), cells * sizeof(double));
    }
    return bytes;
}

TEST(BrdfFile, OfMerlReadsTheModelItWasMadeFrom)
{
    const TemporaryFolder folder;
    const GgxBrdf model{0.3};
    write(folder / "ggx.binary", merlBytes(model, 1000));
    const MeasuredBrdf brdf = readBrdf(folder / "ggx.binary");
    EXPECT_GE(brdf.gaps().holes, 1000u);
    double most = 0.0;
    for (int i = 0; i < 400; ++i) {
        const double tl = 1.3 * std::fmod(0.618 * i, 1.0), tv = 1.3 * std::fmod(0.414 * i, 1.0), phi = 2.4 * i;
        const double nl = std::cos(tl), nv = std::cos(tv), lv = nl * nv + std::sin(tl) * std::sin(tv) * std::cos(phi);
        const glm::dvec3 f = brdf.value(nl, nv, lv);
        EXPECT_LT(glm::distance(f, glm::dvec3(f.g)), 1e-5 * f.g) << "the channels' scales are undone";
        most = std::max(most, std::abs(f.g - model.value(nl, nv, lv)) / model.value(nl, nv, lv));
    }
    EXPECT_LT(most, 0.05) << "cells of a degree, filled holes beside grazing angles";
    for (const double view : {0.0, 0.8, 1.2})
        EXPECT_NEAR(directionalAlbedo({brdf}, view).g, directionalAlbedo({model}, view).g, 0.02) << view;
}

TEST(BrdfFile, OfCornellKeepsTheMeasuredValuesAndTheHighlight)
{
    SHARED_DATA_OR_SKIP(path, "brdf/cornell_garnet_red.brdf");
    const MeasuredBrdf brdf = readBrdf(path);
    EXPECT_GT(brdf.gaps().samples, 1400u);
    EXPECT_EQ(brdf.gaps().holes, 0u);
    // Red paint: away from the highlight its red is far above its blue; in the highlight of an oblique view it is white.
    const auto at = [&](double thetaIDeg, double thetaRDeg, double phiDeg) {
        const double a = thetaIDeg * pi / 180, b = thetaRDeg * pi / 180;
        return brdf.value(std::cos(a), std::cos(b), std::cos(a) * std::cos(b) + std::sin(a) * std::sin(b) * std::cos(phiDeg * pi / 180));
    };
    const glm::dvec3 body = at(30, 50.2, 90), highlight = at(70, 70, 180);
    EXPECT_GT(body.r, 4.0 * body.b);
    EXPECT_LT(highlight.r, 1.5 * highlight.b);
    EXPECT_GT(highlight.g, 20.0 * body.g);
    // A sample of the file itself: theta_i 80, theta_s 79.05, phi 180, in green about 28 1/sr at 550 nm.
    EXPECT_NEAR(at(80.0, 79.05, 180).g, 28.1, 2.0);
    EXPECT_LT(glm::distance(at(35, 20, 30), at(20, 35, -30)), 1e-12) << "light may be traced both ways";
}

TEST(BrdfFile, OfNistIsNearlyAWhiteDiffuser)
{
    SHARED_DATA_OR_SKIP(path, "brdf/nist_PTFE.data.csv");
    const Brdf brdf{readBrdf(path)};
    for (const double view : {0.0, 0.5, 0.9})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(directionalAlbedo(brdf, view)[c], 0.98, 0.06) << "sintered PTFE reflects 97 to 99 % of visible light";
}

TEST(BrdfFile, OfATableTakesColorsAndWavelengths)
{
    const TemporaryFolder folder;
    write(folder / "rgb.csv", "theta_i,phi_i,theta_o,phi_o,r,g,b\n0,0,0,180,0.3,0.2,0.1\n30,0,30,180,0.6,0.4,0.2\n60,0,60,180,-1,0,0\n");
    const MeasuredBrdf rgb = readBrdf(folder / "rgb.csv");
    EXPECT_EQ(rgb.gaps().samples, 3u);
    EXPECT_EQ(rgb.gaps().holes, 1u);
    const double c = std::cos(pi / 6);
    EXPECT_LT(glm::distance(rgb.value(c, c, 0.5), glm::dvec3(0.6, 0.4, 0.2)), 1e-6);
    write(folder / "gray.txt", "wavelength theta_i theta_r phi_r value\n0.45 10 10 180 0.5\n0.55 10 10 180 0.5\n650 10 10 180 0.5\n");
    const double d = std::cos(pi / 18);
    EXPECT_LT(glm::distance(readBrdf(folder / "gray.txt").value(d, d, std::cos(pi / 9)), glm::dvec3(0.5)), 1e-6)
        << "the same at every wavelength is gray, in micrometers and nanometers";
}

TEST(BrdfFile, SaysWhereABadFileIsBad)
{
    const TemporaryFolder folder;
    const std::tuple<const char*, std::string, const char*> cases[] = {
        {"a.csv", "theta_i,theta_r,phi_r,value\n", "row 1: expected the names of the columns"},
        {"b.csv", "theta_i,theta_r,phi_r,r,g,b\n0,0,0,1,1,x\n", "row 2: expected b as value 6; it is \"x\""},
        {"c.csv", "theta_i,theta_r,phi_r,r,g,b\n0,0,0,1,1\n", "row 2: ends after 5 values"},
        {"d.csv", "theta_i,theta_r,phi_r,r,g,b\n0,0,0,1,1,1", "ends inside row 2"},
        {"e.csv", "", "is empty"},
        {"f.brdf", "# x\n3\n400 500\n", "ends after 2 of 3 wavelengths"},
        {"g.brdf", "1\n400\n0.1 0 0.1 3.14\n", "row 3: ends after 4 values; expected a spectral value"},
        {"h.brdf", "2\n500 400\n", "row 2: expected 2 increasing wavelengths"},
        {"i.brdf", "1\n400\n0.1 0 0.1 3.14 1 2\n", "row 3: expected 4 angles and 1 spectral values; there are 6"},
        {"j.binary", "abc", "ends at byte 3"},
        {"k.binary", std::string(12, '\1'), "at byte 0: expected 90"},
        {"l.csv", "theta_i,theta_r,phi_r,r,g,b\n95,0,0,1,1,1\n", "holds no row"},
    };
    for (const auto& [name, bytes, expected] : cases) {
        write(folder / name, bytes);
        try {
            readBrdf(folder / name);
            ADD_FAILURE() << name;
        } catch (const FileError& e) {
            EXPECT_THAT(e.what(), testing::HasSubstr(expected));
            EXPECT_THAT(e.what(), testing::HasSubstr(name));
            EXPECT_THAT(e.what(), testing::Not(testing::HasSubstr("\n")));
        }
    }
}

// A file cut anywhere is refused in one line, or, where the cut falls between two rows of a text, read as the shorter table it is.
TEST(BrdfFile, CutAnywhereIsRefusedInOneLine)
{
    SHARED_DATA_OR_SKIP(data, "brdf");
    const TemporaryFolder folder;
    write(folder / "whole.binary", merlBytes(GgxBrdf{0.5}, 10));
    std::mt19937 generator(5);
    for (const auto& path : {folder / "whole.binary", data / "cornell_mystique.brdf", data / "nist_PTFE.data.csv"}) {
        const std::string bytes = test::readBytes(path);
        const bool isText = path.extension() != ".binary";
        for (int i = 0; i < (isText ? 50 : 8); ++i) {
            const size_t length = generator() % bytes.size();
            const auto cut = folder / ("cut" + path.extension().string());
            write(cut, bytes.substr(0, length));
            const bool betweenRows = isText && length > 0 && bytes[length - 1] == '\n';
            try {
                readBrdf(cut);
                EXPECT_TRUE(betweenRows) << path << " cut to " << length;
            } catch (const FileError& e) {
                EXPECT_THAT(e.what(), testing::Not(testing::HasSubstr("\n")));
            }
        }
    }
}

} // namespace
} // namespace mirrorball
