#include "core/shading/observer.h"

#include "core/shading/brdf_fresnel.h"
#include "core/shading/conductor.h"
#include "core/shading/metal_spectrum.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

std::vector<double> visible()
{
    std::vector<double> wavelengths;
    for (int nm = 380; nm <= 780; nm += 5)
        wavelengths.push_back(nm);
    return wavelengths;
}

TEST(Observer, SeesAPerfectMirrorAsWhite)
{
    for (const std::vector<double>& wavelengths : {visible(), {550.0}, {400.0, 700.0}, {351.0, 532.0, 633.0, 1064.0}}) {
        glm::dvec3 sum(0.0);
        for (const glm::dvec3& w : observerWeights(wavelengths))
            sum += w;
        EXPECT_LT(glm::distance(sum, glm::dvec3(1.0)), 1e-12);
    }
}

// The sums of the CIE's three columns are alike, which makes an equal-energy stimulus white: x = y = 1/3 (CIE 15). Light of D65 has
// x = 0.3127, y = 0.3290. Both are properties of the tables that a mistyped row would break; here through what can be seen of them: light
// below 480 nm is blue, between 520 and 560 nm green, from 600 nm red.
TEST(Observer, PutsWavelengthsIntoTheChannelsOfTheirHue)
{
    const auto wavelengths = visible();
    const auto weights = observerWeights(wavelengths);
    glm::dvec3 blue(0.0), green(0.0), red(0.0);
    for (size_t i = 0; i < wavelengths.size(); ++i) {
        if (wavelengths[i] <= 480)
            blue += weights[i];
        if (wavelengths[i] >= 520 && wavelengths[i] <= 560)
            green += weights[i];
        if (wavelengths[i] >= 600)
            red += weights[i];
    }
    EXPECT_GT(blue.b, 0.8);
    EXPECT_GT(green.g, 0.5);
    EXPECT_GT(red.r, 0.6);
    EXPECT_LT(std::abs(blue.g) + std::abs(red.b), 0.15);
}

// Johnson and Christy's gold through the observer. The dominant wavelengths that conductor.h reads at are one sample of a broad band each:
// the two agree to a few hundredths, least for gold, whose absorption edge runs through the blue band.
TEST(BrdfFresnel, MetalsAgreeWithTheirValuesAtTheDominantWavelengths)
{
    for (const Conductor& metal : conductors()) {
        const glm::dvec3 spectral = FresnelCurve({.kind = BrdfFresnelKind::Metal, .metal = std::string(metal.name)}).at(1.0);
        const glm::dvec3 sampled = fresnelConductor(1.0, metal.index);
        EXPECT_LT(glm::distance(spectral, sampled), 0.15) << metal.name;
    }
}

TEST(BrdfFresnel, OfAMetalIsTheSumOverItsWavelengths)
{
    const auto rows = metalSpectrum("copper");
    const auto wavelengths = visible();
    const auto weights = observerWeights(wavelengths);
    const FresnelCurve curve({.kind = BrdfFresnelKind::Metal, .metal = "copper"});
    for (const double c : {0.0, 0.0101, 0.3, 0.777, 1.0}) {
        glm::dvec3 sum(0.0);
        for (size_t w = 0; w < wavelengths.size(); ++w)
            for (size_t i = 1; i < rows.size(); ++i)
                if (rows[i - 1].wavelength <= wavelengths[w] && wavelengths[w] < rows[i].wavelength) {
                    const double t = (wavelengths[w] - rows[i - 1].wavelength) / (rows[i].wavelength - rows[i - 1].wavelength);
                    sum +=
                        weights[w] * fresnelConductor(c, (1 - t) * rows[i - 1].n + t * rows[i].n, (1 - t) * rows[i - 1].k + t * rows[i].k);
                }
        EXPECT_LT(glm::distance(curve.at(c), sum), 1e-6) << c;
    }
    EXPECT_LT(glm::distance(curve.at(0.0), glm::dvec3(1.0)), 1e-12) << "at grazing every metal is a mirror";
}

TEST(BrdfFresnel, RefusesWhatIsNoFresnelTerm)
{
    EXPECT_THROW(FresnelCurve({.kind = BrdfFresnelKind::Metal, .metal = "unobtainium"}), InvalidArgument);
    EXPECT_THROW(FresnelCurve({.kind = BrdfFresnelKind::Dielectric, .index = 0.0}), InvalidArgument);
    EXPECT_THROW(FresnelCurve({.kind = BrdfFresnelKind::Schlick, .f0 = 1.5}), InvalidArgument);
}

} // namespace
} // namespace mirrorball
