#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <array>
#include <span>
#include <vector>

namespace mirrorball {

/// A probe split into a calm part and the excess of its brightest texels.
///
/// A sun of some dozen texels holds most of a probe's energy and its spectrum is flat, so that a lobe with a kink at the horizon
/// (diffuse, rough ggx, small exponents), whose own spectrum falls slowly, would have to be followed to l of 1500; and whatever the lobe,
/// what a truncation misses of it is spread over the dark. The sum is linear: the excess of those texels goes through the lobe one by
/// one, in closed form, and the calm rest is done by a short spectrum.
struct BrightTexels {
    std::vector<glm::dvec3> directions{};
    std::vector<glm::dvec3> flux{}; ///< excess radiance times texel solid angle, RGB

    /// A texel as the probe has it and as the calm part has it.
    struct Change {
        int x, y;
        glm::dvec3 before, calm;
    };
    std::vector<Change> changes{};
    glm::dvec3 energy{0.0};  ///< sum of w (before - calm)
    glm::dvec3 squares{0.0}; ///< sum of w (before^2 - calm^2)
};

/// How many texels are taken out at most, and the share of the energy of what is left that each of them holds at least. 0: none.
struct BrightSplit {
    size_t mostTexels;
    double smallestShare;
};
inline constexpr std::array<BrightSplit, 4> brightSplits{{{0, 1.0}, {96, 1.0 / 2000.0}, {1024, 1e-4}, {8192, 1e-5}}};

/// Whether a lobe is applied to the bright texels one by one from the start: those with a long spectrum of their own, whose kernel is
/// cheap.
bool splitsBrightTexels(const Lobe& lobe);

/// Finds a probe's brightest texels among rows that come one block after the other; keeps few.
class BrightTexelFinder {
public:
    /// @param deepest  index into brightSplits: no deeper one will be taken
    explicit BrightTexelFinder(const MapLayout& latlong, size_t deepest = brightSplits.size() - 1) : m_layout(latlong), m_deepest(deepest)
    {
    }
    size_t deepest() const { return m_deepest; }
    /// Rows [firstRow, firstRow + rows), 3 floats a texel. What is found does not depend on how the rows are cut into blocks.
    void addRows(int firstRow, int rows, const float* rgb);
    /// @param split  index into brightSplits
    BrightTexels take(size_t split) const;

private:
    struct Candidate {
        double power; ///< texel solid angle times |R| + |G| + |B|
        int x, y;
        std::array<float, 3> radiance;
        /// Brightest first; among equals the first in the map.
        bool operator<(const Candidate& other) const;
    };
    void dropDimmest();

    MapLayout m_layout;
    size_t m_deepest;
    std::vector<double> m_rowPower{};
    std::vector<Candidate> m_candidates{};
    double m_floor = 0.0; ///< no texel below it is among the brightest
};

/// Bright texels seen through a lobe: sum_b flux_b k(r.d_b), not yet divided by the filter of a constant 1.
class BrightLobe {
public:
    BrightLobe(const BrightTexels& bright, const Lobe& lobe);
    bool empty() const { return m_x.empty(); }
    glm::dvec3 radiance(const glm::dvec3& r) const;

private:
    /// Neighbors on the sphere, so that a narrow lobe passes over most of them at once.
    struct Group {
        glm::dvec3 center;
        double cosReach; ///< the lobe is 0 for all of them where r.center is less
        size_t first, last;
    };

    Lobe m_lobe;
    LobeShape m_shape;
    std::vector<Group> m_groups{};
    std::vector<double> m_x{}, m_y{}, m_z{}, m_red{}, m_green{}, m_blue{}; ///< planes, so that the sums vectorise
};

} // namespace mirrorball
