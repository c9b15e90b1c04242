#include "probe_statistics.h"

#include "color.h"

#include <algorithm>
#include <limits>

namespace mirrorball {

StatisticsBuilder::StatisticsBuilder(const MapLayout& layout)
    : m_layout(layout), m_solidAngles(layout),
      m_mostBright(std::max<size_t>(1, static_cast<size_t>(layout.width()) * static_cast<size_t>(layout.height()) / 10000)),
      m_threshold(-std::numeric_limits<double>::infinity())
{
    m_statistics.minLuminance = std::numeric_limits<double>::infinity();
    m_statistics.maxLuminance = -std::numeric_limits<double>::infinity();
}

void StatisticsBuilder::keepBrightest(size_t count)
{
    if (m_bright.size() <= count)
        return;
    const auto last = m_bright.begin() + static_cast<ptrdiff_t>(count - 1);
    std::nth_element(m_bright.begin(), last, m_bright.end(), [](const Bright& a, const Bright& b) { return a.luminance > b.luminance; });
    m_threshold = last->luminance;
    m_bright.resize(count);
}

void StatisticsBuilder::addRows(int firstRow, int rows, const float* rgb)
{
    ProbeStatistics& s = m_statistics;
    for (int y = firstRow; y < firstRow + rows; ++y)
        for (int x = 0; x < m_layout.width(); ++x, rgb += 3) {
            const double solidAngle = m_solidAngles.at(x, y);
            if (solidAngle <= 0.0)
                continue;
            const glm::dvec3 value(rgb[0], rgb[1], rgb[2]);
            const double l = luminance(value);
            for (int c = 0; c < 3; ++c) {
                s.largestValue = std::max(s.largestValue, value[c]);
                s.beyondHalf += value[c] > 65504.0 ? 1 : 0;
            }
            s.minLuminance = std::min(s.minLuminance, l);
            if (l > s.maxLuminance) {
                s.maxLuminance = l;
                m_brightest = {x, y};
            }
            s.meanRadiance += solidAngle * value;
            m_solidAngle += solidAngle;
            m_energy += solidAngle * l;
            ++m_texels;
            if (l >= m_threshold) {
                m_bright.push_back({l, solidAngle * l});
                if (m_bright.size() >= 2 * m_mostBright + 1024)
                    keepBrightest(m_mostBright);
            }
        }
}

ProbeStatistics StatisticsBuilder::finish()
{
    ProbeStatistics s = m_statistics;
    s.meanRadiance /= m_solidAngle;
    s.meanLuminance = m_energy / m_solidAngle;
    s.brightestDirection = texelDirection(m_layout, m_brightest.x, m_brightest.y);
    keepBrightest(std::max<size_t>(1, m_texels / 10000));
    double held = 0.0;
    for (const Bright& bright : m_bright)
        held += bright.energy;
    s.sunShare = m_energy > 0.0 ? held / m_energy : 0.0;
    return s;
}

ProbeStatistics statistics(const EnvironmentMap& map)
{
    StatisticsBuilder builder(map.layout);
    builder.addRows(0, map.image.height, map.image.texels.data());
    return builder.finish();
}

} // namespace mirrorball
