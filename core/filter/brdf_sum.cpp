#include "brdf_sum.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Cosine of the angle from r beyond which no ring of the kernel reaches 1e-13 of its peak.
double cosSupport(const ReflectionKernel& kernel, const LobeNodes& nodes, const std::array<std::vector<double>, 3>& values)
{
    std::vector<double> highest(nodes.rings.size());
    double peak = 0.0;
    for (size_t r = 0; r < nodes.rings.size(); ++r) {
        for (size_t c = 0; c < kernel.channels(); ++c)
            for (size_t i = nodes.rings[r].first; i < nodes.end(r); ++i)
                highest[r] = std::max(highest[r], std::abs(values[c][i]));
        peak = std::max(peak, highest[r]);
    }
    size_t last = nodes.rings.size();
    while (last > 0 && highest[last - 1] <= 1e-13 * peak)
        --last;
    return last == nodes.rings.size() ? -1.0 : std::cos(nodes.rings[last].gamma);
}

glm::dvec3 integral(const ReflectionKernel& kernel, const LobeNodes& nodes, const std::array<std::vector<double>, 3>& values)
{
    glm::dvec3 sum(0.0);
    for (size_t r = 0; r < nodes.rings.size(); ++r)
        for (size_t i = nodes.rings[r].first; i < nodes.end(r); ++i)
            for (size_t c = 0; c < kernel.channels(); ++c)
                sum[static_cast<int>(c)] += nodes.rings[r].weight * nodes.chiWeight[i] * values[c][i];
    return kernel.isGray() ? glm::dvec3(sum.x) : sum;
}

} // namespace

/// The texels of a row that count, gathered.
struct BrdfSum::Scratch {
    explicit Scratch(size_t width) : nl(width), lv(width), columns(width), alongN(width), alongR(width)
    {
        for (auto& channel : k)
            channel.resize(width);
    }
    std::vector<double> nl, lv;
    std::vector<int> columns;
    std::vector<double> alongN, alongR;
    std::array<std::vector<double>, 3> k;
};

BrdfSum::BrdfSum(const EnvironmentMap& latlong, const Brdf& brdf, double view)
    : m_kernel(brdf, view), m_width(latlong.image.width), m_height(latlong.image.height)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("brdf: the probe must be a latlong map; reproject it first");
    const LobeNodes nodes = lobeNodes(view);
    const auto values = kernelAtNodes(m_kernel, nodes);
    m_albedo = integral(m_kernel, nodes, values);
    m_cosSupport = cosSupport(m_kernel, nodes, values);

    const auto w = static_cast<size_t>(m_width), h = static_cast<size_t>(m_height);
    m_texels.resize(3 * w * h);
    for (size_t y = 0; y < h; ++y)
        for (size_t x = 0; x < w; ++x)
            for (size_t c = 0; c < 3; ++c)
                m_texels[(3 * y + c) * w + x] = latlong.image.texels[(y * w + x) * 3 + c];
    for (size_t x = 0; x < w; ++x) {
        const double lon = pi - 2.0 * pi * (static_cast<double>(x) + 0.5) / m_width;
        m_sinLon.push_back(std::sin(lon));
        m_cosLon.push_back(std::cos(lon));
    }
    for (size_t y = 0; y < h; ++y) {
        const double lat = pi / 2 - pi * (static_cast<double>(y) + 0.5) / m_height;
        m_sinLat.push_back(std::sin(lat));
        m_cosLat.push_back(std::cos(lat));
        m_weight.push_back(std::cos(lat)); // the solid angle up to a factor that cancels: both sums carry it
    }
}

glm::dvec3 BrdfSum::sum(const glm::dvec3& n, const glm::dvec3& r, Scratch& s) const
{
    const auto width = static_cast<size_t>(m_width);
    for (size_t x = 0; x < width; ++x) {
        s.alongN[x] = n.x * m_sinLon[x] + n.z * m_cosLon[x];
        s.alongR[x] = r.x * m_sinLon[x] + r.z * m_cosLon[x];
    }
    const double highestN = *std::max_element(s.alongN.begin(), s.alongN.end());
    const double highestR = *std::max_element(s.alongR.begin(), s.alongR.end());
    const double nv2 = 2.0 * m_kernel.cosView();
    glm::dvec3 light(0.0), norm(0.0);
    const std::array<double*, 3> out{s.k[0].data(), s.k[1].data(), s.k[2].data()};
    for (size_t y = 0; y < static_cast<size_t>(m_height); ++y) {
        const double aN = n.y * m_sinLat[y], aR = r.y * m_sinLat[y], b = m_cosLat[y];
        if (aN + b * highestN <= 0.0 || aR + b * highestR < m_cosSupport)
            continue;
        size_t count = 0;
        for (size_t x = 0; x < width; ++x) {
            const double nl = aN + b * s.alongN[x], rl = aR + b * s.alongR[x];
            s.nl[count] = nl;
            s.lv[count] = nv2 * nl - rl; // v = 2 (n.v) n - r
            s.columns[count] = static_cast<int>(x);
            count += nl > 0.0 && rl >= m_cosSupport ? 1 : 0;
        }
        if (count == 0)
            continue;
        m_kernel.evaluate({s.nl.data(), count}, {s.lv.data(), count}, out);
        for (size_t c = 0; c < 3; ++c) {
            const double* k = s.k[m_kernel.isGray() ? 0 : c].data();
            const double* texels = m_texels.data() + (3 * y + c) * width;
            double rowLight = 0.0, rowNorm = 0.0;
            for (size_t i = 0; i < count; ++i) {
                rowLight += k[i] * texels[s.columns[i]];
                rowNorm += k[i];
            }
            light[static_cast<int>(c)] += m_weight[y] * rowLight;
            norm[static_cast<int>(c)] += m_weight[y] * rowNorm;
        }
    }
    glm::dvec3 result(0.0);
    for (int c = 0; c < 3; ++c)
        result[c] = norm[c] > 0.0 ? m_albedo[c] * light[c] / norm[c] : 0.0;
    return result;
}

std::vector<glm::dvec3> BrdfSum::at(std::span<const glm::dvec3> normals, std::span<const glm::dvec3> mirrored, const JobControl& job) const
{
    std::vector<glm::dvec3> result(normals.size());
    parallelRows(
        static_cast<int>(normals.size()), job,
        [&](int first, int last) {
            Scratch scratch(static_cast<size_t>(m_width));
            for (int i = first; i < last; ++i)
                result[static_cast<size_t>(i)] = sum(normals[static_cast<size_t>(i)], mirrored[static_cast<size_t>(i)], scratch);
        },
        16);
    return result;
}

EnvironmentMap filterBrdfSum(const EnvironmentMap& latlong, const Brdf& brdf, const SurfaceView& seen, const MapLayout& target, double yaw,
                             const JobControl& job)
{
    EnvironmentMap map(target);
    std::vector<glm::dvec3> normals, mirrored;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            // Turned before the frame is made: a turn about +Y carries meridians into meridians.
            mirrored.push_back(yawed(texelDirection(target, x, y), -yaw));
            normals.push_back(normalAt(mirrored.back(), seen));
        }
    const std::vector<glm::dvec3> values = BrdfSum(latlong, brdf, seen.view).at(normals, mirrored, job);
    for (size_t i = 0; i < values.size(); ++i)
        for (size_t c = 0; c < 3; ++c)
            map.image.texels[3 * i + c] = static_cast<float>(values[i][static_cast<int>(c)]);
    return map;
}

} // namespace mirrorball
