#include "engine_shaders.h"

#include "core/filter/prefilter.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mirrorball::proof {

namespace {

using Levels = std::vector<EnvironmentMap>;

glm::dvec3 trilinear(const Levels& levels, const glm::dvec3& d, double level)
{
    const double l = std::clamp(level, 0.0, static_cast<double>(levels.size() - 1));
    const auto below = static_cast<size_t>(l);
    const size_t above = std::min(below + 1, levels.size() - 1);
    const double share = l - static_cast<double>(below);
    return (1.0 - share) * glm::dvec3(levels[below].radiance(d)) + share * glm::dvec3(levels[above].radiance(d));
}

class OfCube final : public Radiance {
public:
    OfCube(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options) : m_law(*profile.law)
    {
        const int size = checkedSize(profile, options.size);
        m_levels = lawChain(probe, m_law, size, chainLevels(profile, size), options);
        if (profile.word == "babylon")
            m_sh = nonNegative(radianceSh(probe.spectrum(2)));
    }
    glm::dvec3 specular(const glm::dvec3& d, double roughness) const override
    {
        return trilinear(m_levels, d, roughnessLevel(m_law, roughness, static_cast<int>(m_levels.size()), m_levels.front().layout.size));
    }
    /// three.js and Filament on the web read the last level; Babylon.js its polynomial.
    glm::dvec3 irradianceOverPi(const glm::dvec3& n) const override
    {
        return m_sh ? mirrorball::irradianceOverPi(*m_sh, n) : glm::dvec3(m_levels.back().radiance(n));
    }

private:
    RoughnessLaw m_law;
    Levels m_levels{};
    std::optional<RadianceSh> m_sh{};
};

class OfNine final : public Radiance {
public:
    explicit OfNine(FilterSource& probe) : m_sh(nonNegative(radianceSh(probe.spectrum(2)))) {}
    glm::dvec3 specular(const glm::dvec3&, double) const override { return glm::dvec3(0.0); }
    glm::dvec3 irradianceOverPi(const glm::dvec3& n) const override { return mirrorball::irradianceOverPi(m_sh, n); }

private:
    RadianceSh m_sh;
};

class OfExactMaps final : public Radiance {
public:
    OfExactMaps(FilterSource& probe, const std::vector<double>& roughnesses)
    {
        constexpr MapLayout target{Parameterization::Cube, 256, 0};
        for (const double roughness : roughnesses)
            m_maps.emplace(roughness, prefilter(probe, {.lobe = ggxLobe(roughness * roughness), .target = target}).map);
        m_diffuse = prefilter(probe, {.lobe = diffuseLobe(), .target = target}).map;
    }
    /// Shaders clamp and widen roughness a little; the map that was made for the ball is the one that is meant.
    glm::dvec3 specular(const glm::dvec3& d, double roughness) const override
    {
        const auto nearest = std::min_element(m_maps.begin(), m_maps.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.first - roughness) < std::abs(b.first - roughness);
        });
        return glm::dvec3(nearest->second.radiance(d));
    }
    glm::dvec3 irradianceOverPi(const glm::dvec3& n) const override { return glm::dvec3(m_diffuse.radiance(n)); }

private:
    std::map<double, EnvironmentMap> m_maps{};
    EnvironmentMap m_diffuse{};
};

/// PlayCanvas' atlas as floats: bilinear lookups in its rectangles, of roots and multipliers as RGBP has them, decoded behind that. With a
/// skybox, mirrors read its cube. Source: playcanvas 2.23.3, chunks envAtlas, reflectionEnvHQ, ambient.
class OfAtlas final : public Radiance {
public:
    OfAtlas(FilterSource& probe, const EngineExportOptions& options)
    {
        m_skybox = reproject(*probe.latlong(), {.target = {Parameterization::Cube, engineProfile("playcanvas").size, 0}});
        const Image atlas = playCanvasAtlas(probe, options);
        for (size_t i = 0; i < atlas.texels.size(); i += 3) {
            const glm::dvec3 roots = glm::sqrt(glm::max(glm::dvec3(atlas.texels[i], atlas.texels[i + 1], atlas.texels[i + 2]), 0.0));
            const double scale = std::clamp(std::max({roots.r, roots.g, roots.b}), 1.0, 8.0);
            m_encoded.emplace_back(glm::min(roots / scale, 1.0), 1.0 - (scale - 1.0) / 7.0); // bytes end at 8 times 1, radiance at 64
        }
    }

    glm::dvec3 specular(const glm::dvec3& d, double roughness) const override
    {
        const double level = 5.0 * roughness, below = std::floor(level);
        const glm::dvec2 uv = uvOf(d);
        const glm::dvec3 rough = glm::mix(lookup(uv, rectangle(below)), lookup(uv, rectangle(below + 1.0)), level - below);
        return glm::mix(glm::dvec3(m_skybox.radiance(d)), rough, std::min(level, 1.0));
    }
    glm::dvec3 irradianceOverPi(const glm::dvec3& n) const override { return lookup(uvOf(n), {128.0, 384.0, 64.0, 32.0}); }

private:
    static glm::dvec4 rectangle(double level)
    {
        const double t = 512.0 * std::exp2(-level);
        return {0.0, 512.0 - t, t, 0.5 * t};
    }
    static glm::dvec2 uvOf(const glm::dvec3& d)
    {
        const glm::dvec3 unit = glm::normalize(d) * glm::dvec3(-1.0, 1.0, 1.0);
        return {std::atan2(unit.x, unit.z) / (2.0 * pi) + 0.5, 0.5 - std::asin(std::clamp(unit.y, -1.0, 1.0)) / pi};
    }
    glm::dvec3 lookup(const glm::dvec2& uv, const glm::dvec4& r) const
    {
        const double x = glm::mix(r.x + 1.0, r.x + r.z - 1.0, uv.x) - 0.5, y = glm::mix(r.y + 1.0, r.y + r.w - 1.0, uv.y) - 0.5;
        const double fx = x - std::floor(x), fy = y - std::floor(y);
        glm::dvec4 sum(0.0);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int tx = std::clamp(static_cast<int>(std::floor(x)) + i, 0, 511),
                          ty = std::clamp(static_cast<int>(std::floor(y)) + j, 0, 511);
                sum += (i != 0 ? fx : 1.0 - fx) * (j != 0 ? fy : 1.0 - fy) * m_encoded[static_cast<size_t>(512 * ty + tx)];
            }
        const glm::dvec3 roots = glm::dvec3(sum) * (8.0 - 7.0 * sum.w);
        return roots * roots;
    }

    EnvironmentMap m_skybox{};
    std::vector<glm::dvec4> m_encoded{}; ///< roots over their multiplier, and its place in [1, 8]
};

/// Directional albedo of GGX with height-correlated Smith masking and F = 1: what the tables of three.js hold. Halton points over the
/// half vector, weight G2 (v.h) / ((n.v) (n.h)) against D-sampling. Source: Walter et al. 2007, Heitz 2014.
double directionalAlbedo(double nv, double roughness)
{
    static std::map<std::pair<int, int>, double> known;
    const std::pair key{static_cast<int>(std::lround(nv * 256.0)), static_cast<int>(std::lround(roughness * 1000.0))};
    if (const auto found = known.find(key); found != known.end())
        return found->second;
    const double alpha = std::max(roughness * roughness, 1e-4), cosV = std::clamp(key.first / 256.0, 1e-3, 1.0);
    const glm::dvec3 v(std::sqrt(1.0 - cosV * cosV), 0.0, cosV);
    const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 / (c * c) - 1.0)) - 1.0); };
    constexpr int count = 1024;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count, phi = 2.0 * pi * std::fmod(i * 0.6180339887498949, 1.0);
        const double cosH = std::sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u)), sinH = std::sqrt(std::max(0.0, 1.0 - cosH * cosH));
        const glm::dvec3 h(sinH * std::cos(phi), sinH * std::sin(phi), cosH);
        const double vh = glm::dot(v, h), cosL = 2.0 * vh * h.z - v.z;
        if (vh > 0.0 && cosL > 0.0)
            sum += vh / (v.z * h.z) / (1.0 + lambda(v.z) + lambda(cosL));
    }
    return known[key] = sum / count;
}

glm::dvec3 reflected(const Pixel& pixel) { return 2.0 * glm::dot(pixel.normal, pixel.view) * pixel.normal - pixel.view; }

/// three.js r187: ShaderChunk envmap_physical_pars_fragment, lights_physical_fragment, lights_physical_pars_fragment
/// (computeMultiscattering with F0 = F90 = 1).
glm::dvec3 threeMetal(const Radiance& radiance, const Pixel& pixel, double roughness, const glm::dmat3& axes)
{
    const double r = std::min(1.0, std::max(roughness, 0.0525) + pixel.normalStep);
    const glm::dvec3 d = glm::normalize(glm::mix(reflected(pixel), pixel.normal, r * r * r * r));
    const double albedo = directionalAlbedo(glm::dot(pixel.normal, pixel.view), r);
    return albedo * radiance.specular(axes * d, r) + (1.0 - albedo) * radiance.irradianceOverPi(axes * pixel.normal);
}

/// Filament 1.53: shaders/src/surface_light_indirect.fs; energy compensation makes a white metal of F0 = 1 reflect everything.
/// gltfio's materials widen the lobe by the normal's variance over a pixel (surface_shading_lit.fs, normalFiltering, with 0.15 and 0.2);
/// the smallest perceptual roughness is that of OpenGL ES, 0.089.
glm::dvec3 filamentMetal(const Radiance& radiance, const Pixel& pixel, double roughness, const glm::dmat3& axes)
{
    const double alpha = roughness * roughness, kernel = std::min(2.0 * 0.15 * pixel.normalVariance, 0.2 * 0.2);
    const double r = std::clamp(std::pow(alpha * alpha + kernel, 0.25), 0.089, 1.0);
    return radiance.specular(axes * glm::normalize(glm::mix(reflected(pixel), pixel.normal, r * r * r * r)), r);
}

/// Babylon.js 9.35: ShadersInclude pbrBlockReflection (MIX_IBL_RADIANCE_WITH_IRRADIANCE), pbrHelperFunctions (MINIMUMVARIANCE 0.0005),
/// pbrBlockImageProcessing (clamped to 30).
glm::dvec3 babylonMetal(const Radiance& radiance, const Pixel& pixel, double roughness, const glm::dmat3& axes)
{
    const double alpha = std::min(1.0, roughness * roughness + 0.0005);
    const glm::dvec3 mixed =
        glm::mix(radiance.specular(axes * reflected(pixel), std::sqrt(alpha)), radiance.irradianceOverPi(axes * pixel.normal), alpha);
    return glm::min(mixed, 30.0);
}

} // namespace

std::unique_ptr<Radiance> ofLevels(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options)
{
    if (profile.word == "playcanvas")
        return std::make_unique<OfAtlas>(probe, options);
    return std::make_unique<OfCube>(probe, profile, options);
}

std::unique_ptr<Radiance> ofExactMaps(FilterSource& probe, const std::vector<double>& roughnesses)
{
    return std::make_unique<OfExactMaps>(probe, roughnesses);
}

std::unique_ptr<Radiance> ofSh(FilterSource& probe) { return std::make_unique<OfNine>(probe); }

glm::dvec3 metal(const std::string& engine, const Radiance& radiance, const Pixel& pixel, double roughness, const glm::dmat3& axes)
{
    if (engine == "three" || (engine == "model-viewer" && roughness > 0.0)) // whose renderer is an older three.js, with sharp mirrors
        return threeMetal(radiance, pixel, roughness, axes);
    if (engine == "filament")
        return filamentMetal(radiance, pixel, roughness, axes);
    if (engine == "babylon")
        return babylonMetal(radiance, pixel, roughness, axes);
    return radiance.specular(axes * reflected(pixel), roughness); // PlayCanvas, and mirrors of engines that filter by themselves
}

glm::dvec3 diffuse(const Radiance& radiance, const Pixel& pixel, const glm::dmat3& axes)
{
    return radiance.irradianceOverPi(axes * pixel.normal);
}

} // namespace mirrorball::proof
