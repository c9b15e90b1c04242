#include "core/filter/brdf_lookups.h"
#include "core/filter/brdf_stack.h"
#include "core/filter/brdf_sum.h"
#include "core/filter/engine_lookups.h"
#include "core/filter/lookup_table.h"
#include "core/filter/reference.h"
#include "core/filter/spin_transform.h"

#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirrorball {
namespace {

const MapLayout smallLatlong{Parameterization::Latlong, 16, 0};

double relRms(const EnvironmentMap& map, const EnvironmentMap& truth) { return errorMetrics(map, truth).relRms; }

/// Written from the definition: every texel, in the frame of the surface, no kernel, no rows.
glm::dvec3 plainSum(const EnvironmentMap& probe, const Brdf& brdf, const glm::dvec3& n, const glm::dvec3& v)
{
    const glm::dvec3 side = glm::normalize(glm::cross(n, std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 other = glm::cross(n, side);
    const auto local = [&](const glm::dvec3& d) { return glm::dvec3(glm::dot(d, side), glm::dot(d, other), glm::dot(d, n)); };
    glm::dvec3 sum(0.0);
    for (int y = 0; y < probe.image.height; ++y)
        for (int x = 0; x < probe.image.width; ++x) {
            const glm::dvec3 d = texelDirection(probe.layout, x, y);
            if (glm::dot(d, n) <= 0.0)
                continue;
            const float* texel = probe.image.texel(x, y);
            sum += texelSolidAngle(probe.layout, x, y) * glm::dot(d, n) * glm::dvec3(texel[0], texel[1], texel[2]) *
                   evaluate(brdf, local(d), local(v));
        }
    return sum;
}

TEST(ReflectionFrame, HasTheNormalTowardsTheZenithAtAzimuthZero)
{
    const glm::dvec3 r = glm::normalize(glm::dvec3(0.3, 0.2, 0.9));
    const glm::dvec3 n = normalAt(r, {0.5, 0.0});
    EXPECT_NEAR(glm::dot(n, r), std::cos(0.5), 1e-12);
    EXPECT_NEAR(n.x / n.z, r.x / r.z, 1e-12) << "on r's meridian";
    EXPECT_GT(n.y, r.y);
    // A quarter turn, right-handed about +Z, carries +Y to -X.
    EXPECT_LT(glm::distance(normalAt({0, 0, 1}, {pi / 2, pi / 2}), glm::dvec3(-1, 0, 0)), 1e-12);
    const glm::dvec3 mirrored = mirrorDirection(2.0 * glm::dot(n, r) * n - r, n);
    EXPECT_LT(glm::distance(mirrored, r), 1e-12);
}

TEST(BrdfSum, IsTheSumOverTexelsInTheFrameOfTheSurface)
{
    const EnvironmentMap probe = test::noiseProbe(64, 3);
    for (const char* text : {"ggx:alpha=0.3", "ggx:alpha=0.3,metal=copper", "phong:exponent=12",
                             "lafortune:exponent=9/exponent=4,cxy=0.8,cz=0.8", "beckmann:alpha=0.4,ior=1.5"}) {
        const Brdf brdf = brdfFromText(text);
        const SurfaceView seen{0.8, 2.1};
        const EnvironmentMap map = filterBrdfSum(probe, brdf, seen, smallLatlong, 0.0);
        for (const Texel at : {Texel{0, 0}, Texel{7, 3}, Texel{20, 9}, Texel{31, 15}}) {
            const glm::dvec3 r = texelDirection(smallLatlong, at.x, at.y), n = normalAt(r, seen), v = 2.0 * glm::dot(n, r) * n - r;
            const glm::dvec3 expected = plainSum(probe, brdf, n, v);
            for (int c = 0; c < 3; ++c) // the plain sum's own quadrature error over a constant differs from 0 by parts in a thousand
                EXPECT_NEAR(map.image.texel(at.x, at.y)[c], expected[c], 4e-3 * expected[c]) << text << ' ' << at.x << ' ' << at.y;
        }
    }
}

TEST(BrdfSum, OfAConstantProbeIsTheAlbedo)
{
    const EnvironmentMap probe = test::constantProbe(32, 2.0f);
    const Brdf brdf = brdfFromText("cook-torrance:m=0.4,metal=gold");
    const EnvironmentMap map = filterBrdfSum(probe, brdf, {1.2, 0.7}, smallLatlong, 0.3);
    const glm::dvec3 albedo = directionalAlbedo(brdf, 1.2);
    for (size_t i = 0; i < map.image.texels.size(); ++i)
        EXPECT_NEAR(map.image.texels[i], 2.0 * albedo[static_cast<int>(i % 3)], 1e-5);
}

// Phong as published reflects one round lobe about r while that lies above the horizon: the reference sum of the lobe.
TEST(BrdfSum, OfPhongSeenStraightOnIsThePhongLobe)
{
    const EnvironmentMap probe = test::noiseProbe(32, 5);
    const EnvironmentMap map = filterBrdfSum(probe, {PhongBrdf{30.0}}, {0.0, 0.0}, smallLatlong, 0.0);
    FilterSource source(probe);
    const EnvironmentMap lobe = prefilter(source, {.lobe = phongLobe(30), .target = smallLatlong, .method = Method::Reference}).map;
    EXPECT_LT(relRms(map, lobe), 1e-6);
}

TEST(BrdfSum, TurnsWithTheEnvironment)
{
    const EnvironmentMap probe = test::noiseProbe(32, 5);
    const Brdf brdf{GgxBrdf{0.3}};
    const EnvironmentMap straight = filterBrdfSum(probe, brdf, {0.9, 0.5}, smallLatlong, 0.0);
    const double texel = 2.0 * pi / 32;
    const EnvironmentMap turned = filterBrdfSum(probe, brdf, {0.9, 0.5}, smallLatlong, 4 * texel);
    for (int x = 0; x < 32; ++x) // longitude falls along the row
        EXPECT_NEAR(turned.image.texel((x + 32 - 4) % 32, 5)[1], straight.image.texel(x, 5)[1], 1e-5);
}

// One bright texel at d: A_m(r) is then kappa_m(gamma) e^(i m phi) times its light, with gamma and phi read off vectors. Directions beside
// the poles, across the seam of the latlong map and in every quarter.
TEST(SpinTransform, GathersLightByItsAzimuthAboutEveryDirection)
{
    EnvironmentMap probe = test::constantProbe(32, 0.0f);
    const int bandLimit = 24;
    probe.image.texel(5, 11)[1] = 1.0f;
    const glm::dvec3 d = texelDirection(probe.layout, 5, 11);
    const double light = texelSolidAngle(probe.layout, 5, 11);
    const Spectrum spectrum = analyze(probe, bandLimit);
    for (const int m : {0, 1, 2, 3, 4, 7, 12}) {
        std::vector<double> k(bandLimit + 1);
        for (int l = m; l <= bandLimit; ++l)
            k[static_cast<size_t>(l)] = std::exp(-0.01 * l * l) * (1.0 + 0.3 * std::sin(3.0 * l));
        RingSet rings;
        std::vector<glm::dvec3> places;
        for (int i = 0; i < 60; ++i) {
            const double theta = i < 5 ? 1e-4 * (i + 1) : i < 10 ? pi - 1e-4 * (i - 4) : pi * std::fmod(0.618 * i, 1.0);
            const double azimuth = 2.4 * i;
            rings.colatitude.push_back(theta);
            rings.azimuth.push_back(azimuth);
            places.push_back(directionFromLonLat(pi - azimuth, pi / 2 - theta));
        }
        const OrderMap map = synthesizeOrder(spectrum, 1, m, k, rings);
        std::vector<double> lambda(bandLimit + 1);
        for (size_t i = 0; i < places.size(); ++i) {
            const Tangents at = tangentsAt(places[i]);
            const double gamma = std::acos(std::clamp(glm::dot(d, places[i]), -1.0, 1.0));
            const double phi = std::atan2(glm::dot(d, at.east), glm::dot(d, at.north));
            OrderHarmonics(m, bandLimit).at(gamma, lambda);
            double kappa = 0.0;
            for (int l = m; l <= bandLimit; ++l)
                kappa += k[static_cast<size_t>(l)] * std::sqrt((2 * l + 1) / (4 * pi)) * lambda[static_cast<size_t>(l)];
            EXPECT_NEAR(map.real[i], light * kappa * std::cos(m * phi), 1e-9 * light) << "order " << m << " place " << i;
            if (m > 0) {
                EXPECT_NEAR(map.imaginary[i], light * kappa * std::sin(m * phi), 1e-9 * light) << "order " << m << " place " << i;
            }
        }
    }
}

TEST(KernelSpectrum, AddsUpToTheKernel)
{
    const Brdf brdf{GgxBrdf{0.4}};
    const double view = 1.0;
    const ReflectionKernel kernel(brdf, view);
    const KernelSpectrum spectrum = kernelSpectrum(kernel, 96, 30);
    EXPECT_NEAR(spectrum.albedo.g, directionalAlbedo(brdf, view).g, 1e-12);
    std::vector<double> lambda(97);
    double peak = 0.0;
    for (const auto& [gamma, chi] : {std::pair{0.0, 0.0}, {0.3, 0.0}, {0.5, 2.0}, {0.3, pi}, {1.2, 0.4}, {1.5, pi}}) {
        double sum = 0.0;
        for (int m = 0; m <= 30; ++m) {
            OrderHarmonics(m, 96).at(gamma, lambda);
            for (int l = m; l <= 96; ++l)
                sum += spectrum.order(m, 0)[static_cast<size_t>(l)] * std::sqrt((2 * l + 1) / (4 * pi)) * lambda[static_cast<size_t>(l)] *
                       std::cos(m * chi);
        }
        const double s = std::sin(gamma) * std::cos(chi);
        const double nl = std::cos(gamma) * std::cos(view) + s * std::sin(view),
                     lv = std::cos(gamma) * std::cos(2 * view) + s * std::sin(2 * view);
        const double expected = nl > 0.0 ? GgxBrdf{0.4}.value(nl, std::cos(view), lv) * nl / spectrum.albedo.g : 0.0;
        peak = std::max(peak, expected);
        EXPECT_NEAR(sum, expected, 3e-3 * std::max(peak, 1.0)) << gamma << ' ' << chi;
    }
    double held = 0.0;
    for (int m = 0; m <= 30; ++m)
        for (int l = m; l <= 96; ++l)
            held += spectrum.term(l, m, 0);
    EXPECT_NEAR(held / spectrum.power[0], 1.0, 1e-4) << "Parseval";
}

TEST(BrdfStack, IsTheBruteForceSumWithinItsPrediction)
{
    for (const EnvironmentMap& probe : {test::noiseProbe(64, 3), test::sunProbe(64, 1e4f, 70, 20)})
        for (const char* text : {"ggx:alpha=0.25", "ggx:alpha=0.09", "ggx:alpha=0.5,metal=copper", "phong:exponent=20",
                                 "cook-torrance:m=0.4,ior=1.5", "lafortune:exponent=9/exponent=4,cxy=0.8,cz=0.8"})
            for (const double view : {0.6, 1.2}) {
                const Brdf brdf = brdfFromText(text);
                FilterSource source(probe);
                const StackPlan plan = planStack(brdf, view, 1e-2, source);
                const EnvironmentMap truth = filterBrdfSum(probe, brdf, {view, 0.8}, smallLatlong, 0.4);
                const double error = relRms(filterBrdfStack(source, plan, 0.8, smallLatlong, 0.4), truth);
                // Phong's lobe ends at the horizon in a step, which white noise sees at every degree: followed as far as it goes, its rest
                // is 1e-2, and the prediction keeps twice that (stackMargin).
                EXPECT_LE(plan.predictedError, view > 1.0 && text == std::string("phong:exponent=20") ? 2.5e-2 : 1e-2)
                    << text << ' ' << view;
                EXPECT_LE(error, plan.predictedError)
                    << text << ' ' << view << ": orders " << plan.kernel.orders << ", degrees " << plan.kernel.bandLimit;
            }
}

TEST(BrdfStack, IsTheSameInEveryParameterization)
{
    const EnvironmentMap probe = test::noiseProbe(32, 8);
    const Brdf brdf{GgxBrdf{0.4}};
    FilterSource source(probe);
    const StackPlan plan = planStack(brdf, 1.0, 3e-3, source);
    for (const Parameterization kind : allParameterizations) {
        const MapLayout target{kind, 12, 0};
        EXPECT_LE(relRms(filterBrdfStack(source, plan, 2.0, target, 0.7), filterBrdfSum(probe, brdf, {1.0, 2.0}, target, 0.7)), 3e-3)
            << name(kind);
    }
}

TEST(BrdfLookups, AddUpToTheAlbedoAndHaveNoNegativeWeight)
{
    for (const char* text : {"ggx:alpha=0.25", "ggx:alpha=0.09,metal=gold", "lafortune:exponent=20/exponent=8,cxy=0.9,cz=0.9,weight=0.5"})
        for (const int count : {1, 3, 5}) {
            const Brdf brdf = brdfFromText(text);
            const LookupFit fit = fitLookups(brdf, 1.0, count);
            glm::dvec3 sum(0.0);
            for (const BrdfLookup& lookup : fit.lookups) {
                sum += lookup.weight;
                EXPECT_GE(glm::compMin(lookup.weight), 0.0);
                EXPECT_GT(lookup.alpha, 0.0);
            }
            EXPECT_LT(glm::distance(sum, directionalAlbedo(brdf, 1.0)), 1e-9) << text << ' ' << count;
        }
}

TEST(BrdfLookups, OfSeveralLeaveLessThanOneAndFarLessThanTheSplitSum)
{
    const EnvironmentMap probe = test::noiseProbe(64, 3);
    FilterSource source(probe);
    const Brdf brdf{GgxBrdf{0.25}};
    const double view = 1.1;
    const EnvironmentMap truth = filterBrdfSum(probe, brdf, {view, 0.4}, smallLatlong, 0.0);
    const auto error = [&](const LookupFit& fit) { return relRms(filterBrdfLookups(source, fit, 0.4, smallLatlong, 0.0, 1e-4), truth); };
    const double engine = error(splitSum(brdf, view)), three = error(fitLookups(brdf, view, 3)), five = error(fitLookups(brdf, view, 5));
    EXPECT_LT(three, 0.5 * engine);
    EXPECT_LT(five, 0.25 * engine);
    EXPECT_LE(five, three);
}

// The frame's turn in the plane of incidence: one lookup, moved by 0.3 towards the normal, is the lobe's map read there.
TEST(BrdfLookups, LieInThePlaneOfIncidenceTowardsTheNormal)
{
    const EnvironmentMap probe = test::noiseProbe(32, 4);
    FilterSource source(probe);
    const LookupFit fit{.view = 0.9, .lookups = {{0.3, 0.3, glm::dvec3(1.0)}}};
    const EnvironmentMap map = filterBrdfLookups(source, fit, 2.2, smallLatlong, 0.0, 1e-6);
    std::vector<glm::dvec3> axes;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const glm::dvec3 r = texelDirection(smallLatlong, x, y), n = normalAt(r, {0.9, 2.2});
            const glm::dvec3 across = glm::normalize(n - glm::dot(n, r) * r);
            axes.push_back(std::cos(0.3) * r + std::sin(0.3) * across);
        }
    const auto expected = referenceSum(probe, ggxLobe(0.3), axes);
    for (size_t i = 0; i < axes.size(); ++i)
        EXPECT_NEAR(map.image.texels[3 * i + 1], expected[i].g, 2e-4);
}

// The same beside the plane: first moved in it, then turned out of it about the axis that lies in it and across the first.
TEST(BrdfLookups, LieBesideThePlaneOfIncidenceByTheirTurn)
{
    const EnvironmentMap probe = test::noiseProbe(32, 4);
    FilterSource source(probe);
    const LookupFit fit{.view = 0.9, .lookups = {{.offset = -0.4, .alpha = 0.3, .weight = glm::dvec3(1.0), .turn = 0.5}}};
    const EnvironmentMap map = filterBrdfLookups(source, fit, 2.2, smallLatlong, 0.0, 1e-6);
    std::vector<glm::dvec3> axes;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const glm::dvec3 r = texelDirection(smallLatlong, x, y), n = normalAt(r, {0.9, 2.2});
            const glm::dvec3 side = glm::normalize(glm::cross(r, n)), across = glm::cross(side, r);
            axes.push_back(std::cos(0.5) * (std::cos(-0.4) * r + std::sin(-0.4) * across) + std::sin(0.5) * side);
        }
    const auto expected = referenceSum(probe, ggxLobe(0.3), axes);
    for (size_t i = 0; i < axes.size(); ++i)
        EXPECT_NEAR(map.image.texels[3 * i + 1], expected[i].g, 2e-4);
}

// Kernels have a left side as they have a right one; a rough one is wider than any lookup of the chain.
TEST(BrdfLookups, OfARoughMaterialStandInPairsBesideThePlane)
{
    const LookupFit fit = fitLookups({GgxBrdf{0.81}}, 0.0, 5), one = fitLookups({GgxBrdf{0.81}}, 0.0, 1);
    double sum = 0.0, turned = 0.0;
    for (const BrdfLookup& lookup : fit.lookups) {
        sum += lookup.weight.g * std::sin(lookup.turn);
        turned += lookup.weight.g * std::abs(std::sin(lookup.turn));
    }
    EXPECT_NEAR(sum, 0.0, 1e-12);
    EXPECT_GT(turned, 0.005);
    EXPECT_LT(fit.residual, 0.5 * one.residual) << "alpha 1 is too narrow";
}

// A material that sends back more to one view than to the next changes its lookups by little.
TEST(BrdfLookups, ChangeSmoothlyWithTheView)
{
    std::vector<double> views;
    for (int i = 0; i < 16; ++i)
        views.push_back(std::acos((i + 0.5) / 16));
    const auto fits = fitLookups({GgxBrdf{0.25}}, views, 3);
    ASSERT_EQ(fits.size(), views.size());
    for (size_t i = 0; i + 1 < fits.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(fits[i].lookups[k].offset, fits[i + 1].lookups[k].offset, 0.5) << i << ' ' << k;
            EXPECT_NEAR(std::log(fits[i].lookups[k].alpha), std::log(fits[i + 1].lookups[k].alpha), 1.0) << i << ' ' << k;
        }
    }
}

// A column is a fit; between columns the table is nearly one.
TEST(LookupTable, IsAFitAtEveryView)
{
    const Brdf brdf = brdfFromText("ggx:alpha=0.25,metal=copper");
    const Image table = makeLookupTable(brdf, {LookupKind::Fitted, 3}, 12);
    ASSERT_EQ(table.height, 6);
    for (int i = 0; i < 12; ++i) {
        const double view = std::acos((i + 0.5) / 12);
        const LookupFit fit = lookupsAt(table, view);
        glm::dvec3 sum(0.0);
        for (const BrdfLookup& lookup : fit.lookups)
            sum += lookup.weight;
        EXPECT_LT(glm::distance(sum, directionalAlbedo(brdf, view)), 1e-6) << i;
    }
    const EnvironmentMap probe = test::noiseProbe(32, 3);
    FilterSource source(probe);
    for (const double view : {0.5, 0.9, 1.2}) {
        const EnvironmentMap truth = filterBrdfSum(probe, brdf, {view, 0.4}, smallLatlong, 0.0);
        const auto error = [&](const LookupFit& fit) {
            return relRms(filterBrdfLookups(source, fit, 0.4, smallLatlong, 0.0, 1e-3), truth);
        };
        EXPECT_LT(error(lookupsAt(table, view)), 0.6 * error(splitSum(brdf, view))) << view;
    }
}

} // namespace
} // namespace mirrorball
