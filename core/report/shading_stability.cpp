#include "shading_stability.h"

#include "core/filter/mip_blur.h"
#include "core/shading/fresnel.h"
#include "core/shading/lambda.h"
#include "core/sphere/sphere_map.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>

namespace mirrorball {

namespace {

using Values = ShadingCase::Values;

/// Cosines from normal incidence to exactly grazing, denser there.
std::vector<double> cosines()
{
    std::vector<double> result{0.0, 1e-300, 1e-12, 1e-9, 1e-6, 1e-4};
    for (int i = 1; i <= 90; ++i)
        result.push_back(std::sin(i * pi / 180.0));
    result.back() = 1.0;
    return result;
}

/// Fresnel's amplitudes with Snell's angle inside, in long double: (|r_s|^2 + |r_p|^2)/2.
double amplitudes(double cosTheta, std::complex<long double> index)
{
    using Wide = std::complex<long double>;
    const long double c = cosTheta;
    const Wide inside = std::sqrt(index * index - (1.0L - c * c)); // index times the cosine inside
    if (index == Wide(1.0L))
        return 0.0;
    const Wide s = (c - inside) / (c + inside), p = (index * index * c - inside) / (index * index * c + inside);
    return static_cast<double>(0.5L * (std::norm(s) + std::norm(p)));
}

void addDielectrics(std::vector<ShadingCase>& cases)
{
    for (const double n : {1.0, 1.0 + 1e-9, 0.2, 1.5, 5.0, 200.0, 1e6}) {
        std::ostringstream name;
        name.precision(10);
        name << "n = " << n << ", normal to exactly grazing";
        cases.push_back({.family = "Fresnel, dielectric",
                         .name = name.str(),
                         .compute =
                             [n](const JobControl&) {
                                 Values result;
                                 for (const double c : cosines()) {
                                     result.values.push_back(fresnelDielectric(c, n));
                                     result.expected.push_back(amplitudes(c, {static_cast<long double>(n), 0.0L}));
                                 }
                                 return result;
                             },
                         .bound = 1e-9});
    }
    cases.push_back({.family = "Fresnel, dielectric",
                     .name = "n = 0.2 past the critical angle: all of it",
                     .compute =
                         [](const JobControl&) {
                             Values result;
                             const double critical = std::sqrt(1.0 - 0.04);
                             for (int i = 0; i < 50; ++i) {
                                 result.values.push_back(fresnelDielectric(critical * (1.0 - 1e-9) * i / 49.0, 0.2));
                                 result.expected.push_back(1.0);
                             }
                             return result;
                         },
                     .bound = 0.0});
}

void addConductors(std::vector<ShadingCase>& cases)
{
    for (const double k : {0.0, 100.0, 1e6})
        for (const double n : {0.05, 1.0, 1.5}) {
            if (n == 1.0 && k == 0.0)
                continue; // no surface: a row of the dielectrics
            std::ostringstream name;
            name << "n = " << n << ", k = " << k << ", normal to exactly grazing";
            cases.push_back(
                {.family = "Fresnel, conductor",
                 .name = name.str(),
                 .compute =
                     [n, k](const JobControl&) {
                         Values result;
                         for (const double c : cosines()) {
                             result.values.push_back(fresnelConductor(c, n, k));
                             result.expected.push_back(amplitudes(c, {static_cast<long double>(n), static_cast<long double>(k)}));
                         }
                         return result;
                     },
                 .bound = 1e-9});
        }
}

void addLambda(std::vector<ShadingCase>& cases)
{
    cases.push_back({.family = "lambda",
                     .name = "past the last level: that level",
                     .compute =
                         [](const JobControl& job) {
                             EnvironmentMap cube(MapLayout{Parameterization::Cube, 8, 0});
                             for (size_t i = 0; i < cube.image.texels.size(); ++i)
                                 cube.image.texels[i] = static_cast<float>((i * 7919) % 101) / 101.0f;
                             const MipPyramid pyramid = blurPyramid(cube, MipFiltering::AcrossSeams, job);
                             const MapLayout target{Parameterization::Cube, 4, 0};
                             Values result;
                             for (const double lambda : {3.0 + 1e-9, 17.0, 32.0})
                                 for (int y = 0; y < target.height(); ++y) {
                                     const EnvironmentMap far = mipBlur(pyramid, MipFiltering::AcrossSeams, lambda, target, 0.0, job);
                                     for (int x = 0; x < target.width(); ++x)
                                         for (int c = 0; c < 3; ++c) {
                                             result.values.push_back(far.image.texel(x, y)[c]);
                                             result.expected.push_back(pyramid.levels.back().radiance(texelDirection(target, x, y))[c]);
                                         }
                                 }
                             return result;
                         },
                     .bound = 1e-6});
    cases.push_back({.family = "lambda",
                     .name = "at exactly grazing angles, g = 0 to 8",
                     .compute =
                         [](const JobControl&) {
                             Values result;
                             for (const double g : {0.0, 1.0, 8.0})
                                 for (const double c : {0.0, 1e-300, 1e-6, 0.25, 1.0}) {
                                     result.values.push_back(lambdaAt(3.0, g, c));
                                     const double octaves = std::log(std::max(c, 1e-6)) / std::log(2.0);
                                     result.expected.push_back(std::max(0.0, 3.0 + g * octaves / 2.0));
                                 }
                             return result;
                         },
                     .bound = 1e-12,
                     .high = 3.0});
}

void addRim(std::vector<ShadingCase>& cases)
{
    // z = 1 - 2 rho^2 and back, at distances from the rim down to a rounding; -Z itself lies on it.
    cases.push_back({.family = "sphere map",
                     .name = "at the rim: direction, and back to the disc",
                     .compute =
                         [](const JobControl&) {
                             Values result;
                             for (const double inward : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3})
                                 for (int i = 0; i < 12; ++i) {
                                     const double angle = 2.0 * pi * (i + 0.25) / 12.0, rho = 1.0 - inward;
                                     const glm::dvec2 q(rho * std::cos(angle), rho * std::sin(angle));
                                     const glm::dvec3 r = sphere_map::directionFromDisc(q);
                                     result.values.insert(result.values.end(), {glm::length(r), r.z});
                                     result.expected.insert(result.expected.end(), {1.0, 1.0 - 2.0 * rho * rho});
                                     result.values.push_back(glm::length(sphere_map::discFromDirection(r)));
                                     result.expected.push_back(rho);
                                 }
                             const glm::dvec2 back = sphere_map::discFromDirection({0.0, 0.0, -1.0});
                             result.values.push_back(glm::length(back));
                             result.expected.push_back(1.0);
                             return result;
                         },
                     .bound = 1e-9,
                     .low = -1.0 - 1e-12,
                     .high = 1.0 + 1e-12});
}

/// Cold-warm shading by its formula, in double, where the code has an approximation of erf in float.
glm::dvec3 coldWarm(const ColdWarmLayer& layer, double x, double y, double texel)
{
    const double angle = layer.angleDeg * pi / 180.0, scale = 1.0 / (std::sqrt(2.0) * std::hypot(layer.blur, texel / std::sqrt(12.0)));
    const glm::dvec2 d(std::cos(angle), std::sin(angle));
    const double half = 0.5 + 0.5 * std::erf((x * d.x + y * d.y + layer.balance) * scale);
    const double far = std::hypot(x - layer.highlightDistance * d.x, y - layer.highlightDistance * d.y);
    const double disc = 0.5 * (std::erf((layer.highlight - far) * scale) + std::erf((layer.highlight + far) * scale));
    return glm::mix(glm::mix(layer.coldColor, layer.warmColor, half), layer.highlightColor, disc);
}

void addPainted(std::vector<ShadingCase>& cases)
{
    for (const int size : {16, largestSphereMap})
        cases.push_back({.family = "painted map",
                         .name = "cold-warm shading at " + std::to_string(size) + " texels",
                         .compute =
                             [size](const JobControl& job) {
                                 const ColdWarmLayer layer;
                                 SphereMapDocument document;
                                 document.layers.push_back({.content = layer});
                                 Values result;
                                 const int edge = std::min(size, 16); // the middle, where the rim meets the axes, and a corner
                                 for (const glm::ivec2& at : {glm::ivec2(size / 2, size / 2), glm::ivec2(edge / 2, size / 2),
                                                              glm::ivec2(size / 2, size - edge / 2), glm::ivec2(edge / 2, edge / 2)}) {
                                     const TexelRect rect{at.x - edge / 2, at.y - edge / 2, at.x + edge / 2, at.y + edge / 2};
                                     const Image painted = evaluate(document, {.size = size, .region = rect}, job);
                                     for (int y = 0; y < edge; ++y)
                                         for (int x = 0; x < edge; ++x) {
                                             glm::dvec2 q((rect.x0 + x + 0.5) * 2.0 / size - 1.0, 1.0 - (rect.y0 + y + 0.5) * 2.0 / size);
                                             q /= std::max(1.0, glm::length(q)); // outside, the rim's color goes on
                                             const glm::dvec3 expected = coldWarm(layer, q.x, q.y, 2.0 / size);
                                             for (int c = 0; c < 3; ++c) {
                                                 result.values.push_back(painted.texel(x, y)[c]);
                                                 result.expected.push_back(expected[c]);
                                             }
                                         }
                                 }
                                 return result;
                             },
                         .bound = 1e-5});
}

} // namespace

std::vector<ShadingCase> shadingCases()
{
    std::vector<ShadingCase> cases;
    addDielectrics(cases);
    addConductors(cases);
    addLambda(cases);
    addRim(cases);
    addPainted(cases);
    return cases;
}

ShadingRow judgeShading(const ShadingCase& test, const ShadingCase::Values& computed)
{
    ShadingRow row{.family = test.family, .name = test.name, .places = computed.values.size(), .bound = test.bound};
    const auto fail = [&row](const char* what, double value) {
        std::ostringstream text;
        text << what << ' ' << value;
        row.failures.push_back(text.str());
    };
    for (size_t i = 0; i < computed.values.size() && row.failures.empty(); ++i) {
        const double value = computed.values[i], expected = computed.expected[i];
        if (!std::isfinite(value)) {
            fail("not finite:", value);
            break;
        }
        if (value < test.low || value > test.high)
            fail("outside its range:", value);
        row.largestError = std::max(row.largestError, std::abs(value - expected) / std::max(1.0, std::abs(expected)));
    }
    if (row.failures.empty() && !(row.largestError <= test.bound))
        fail("error", row.largestError);
    if (computed.values.empty() || computed.values.size() != computed.expected.size())
        fail("nothing to judge:", static_cast<double>(computed.values.size()));
    return row;
}

ShadingRow runShading(const ShadingCase& test, const JobControl& job) { return judgeShading(test, test.compute(job)); }

} // namespace mirrorball
