#include "bright_texels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirrorball {

namespace {

constexpr size_t mostTexels = 96;
constexpr double smallestShare = 1.0 / 2000.0;

} // namespace

bool splitsBrightTexels(const Lobe& lobe) { return lobe.kind != LobeKind::Phong || lobe.exponent < 8.0; }

BrightTexels takeBrightTexels(EnvironmentMap& latlong)
{
    Image& image = latlong.image;
    const size_t texels = image.texels.size() / 3;
    std::vector<double> power(texels);
    for (int y = 0; y < image.height; ++y) {
        const double solidAngle = texelSolidAngle(latlong.layout, 0, y);
        for (int x = 0; x < image.width; ++x) {
            const float* t = image.texel(x, y);
            power[image.index(x, y) / 3] = solidAngle * (std::abs(t[0]) + std::abs(t[1]) + std::abs(t[2]));
        }
    }
    const double threshold = smallestShare * std::accumulate(power.begin(), power.end(), 0.0);
    std::vector<size_t> brightest;
    for (size_t i = 0; i < texels; ++i)
        if (power[i] > threshold)
            brightest.push_back(i);
    std::sort(brightest.begin(), brightest.end(), [&](size_t a, size_t b) { return power[a] != power[b] ? power[a] > power[b] : a < b; });
    const double level = brightest.size() > mostTexels ? power[brightest[mostTexels]] : threshold;
    brightest.resize(std::min(brightest.size(), mostTexels));

    BrightTexels bright;
    for (const size_t i : brightest) {
        const int x = static_cast<int>(i % static_cast<size_t>(image.width)), y = static_cast<int>(i / static_cast<size_t>(image.width));
        float* t = image.texel(x, y);
        glm::dvec3 excess;
        for (int c = 0; c < 3; ++c) { // what stays is the float that is stored, so that the two parts add up exactly
            const double whole = t[c];
            t[c] = static_cast<float>(whole * level / power[i]);
            excess[c] = whole - t[c];
        }
        bright.directions.push_back(texelDirection(latlong.layout, x, y));
        bright.flux.push_back(excess * texelSolidAngle(latlong.layout, x, y));
    }
    return bright;
}

BrightLobe::BrightLobe(const BrightTexels& bright, const Lobe& lobe) : m_lobe(lobe), m_shape(lobe)
{
    const double peak = 1.0 / m_shape.integral();
    for (size_t i = 0; i < bright.directions.size(); ++i) {
        m_x.push_back(bright.directions[i].x);
        m_y.push_back(bright.directions[i].y);
        m_z.push_back(bright.directions[i].z);
        m_red.push_back(peak * bright.flux[i].r);
        m_green.push_back(peak * bright.flux[i].g);
        m_blue.push_back(peak * bright.flux[i].b);
    }
}

glm::dvec3 BrightLobe::radiance(const glm::dvec3& r, std::vector<double>& weights) const
{
    const size_t count = m_x.size();
    weights.resize(count);
    for (size_t i = 0; i < count; ++i)
        weights[i] = std::min(1.0, r.x * m_x[i] + r.y * m_y[i] + r.z * m_z[i]);
    if (m_lobe.kind == LobeKind::Diffuse)
        for (double& w : weights)
            w = std::max(w, 0.0);
    else if (m_lobe.kind == LobeKind::Ggx) { // as LobeShape::relative, written out so that it vectorises
        const double a2 = m_lobe.alpha * m_lobe.alpha;
        for (double& w : weights) {
            const double ratio = a2 / (0.5 * (1.0 - w) + a2 * 0.5 * (1.0 + w));
            w = std::max(w, 0.0) * ratio * ratio;
        }
    } else
        for (double& w : weights)
            w = m_shape.relative(w);
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < count; ++i)
        sum += weights[i] * glm::dvec3(m_red[i], m_green[i], m_blue[i]);
    return sum;
}

} // namespace mirrorball
