#pragma once

#include "environment_map.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace mirrorball {

/// Figures that tell what a probe holds. Luminance is Rec.709's; means are weighted by solid angle; texels outside a disc do not count.
struct ProbeStatistics {
    double minLuminance = 0.0;
    double maxLuminance = 0.0;
    glm::dvec3 meanRadiance{0.0};
    double meanLuminance = 0.0;
    glm::dvec3 brightestDirection{0.0, 1.0, 0.0};
    /// Share of the energy (luminance times solid angle) that the brightest 0.01 % of the texels hold, at least one; 0 for a black probe.
    double sunShare = 0.0;
    double largestValue = 0.0;   ///< of any channel
    std::int64_t beyondHalf = 0; ///< channel values above 65504, which a half float cannot hold
};

ProbeStatistics statistics(const EnvironmentMap& map);

/// The same for rows that arrive one block after the other, so that a probe of any size streams through. Keeps no more than the brightest
/// texels (a hundred-thousandth of a 16k probe's memory) and the solid angles of one chart.
class StatisticsBuilder {
public:
    explicit StatisticsBuilder(const MapLayout& layout);

    /// Rows [firstRow, firstRow + rows), 3 floats a texel, finite; from the top, each once.
    void addRows(int firstRow, int rows, const float* rgb);
    ProbeStatistics finish();

private:
    struct Bright {
        double luminance, energy;
    };
    /// Leaves only the brightest `count` in m_bright.
    void keepBrightest(size_t count);

    MapLayout m_layout;
    SolidAngles m_solidAngles;
    size_t m_mostBright; ///< more than can count in the end
    double m_threshold;  ///< no texel below it can
    std::vector<Bright> m_bright{};
    size_t m_texels = 0;
    double m_solidAngle = 0.0, m_energy = 0.0;
    Texel m_brightest{};
    ProbeStatistics m_statistics{};
};

} // namespace mirrorball
