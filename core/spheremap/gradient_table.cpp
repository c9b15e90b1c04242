#include "gradient_table.h"

#include "oklab.h"

#include <algorithm>

namespace mirrorball {

namespace {
using namespace std::string_view_literals;
constexpr std::array colorMixingWords{"oklab"sv, "linear"sv};
} // namespace

std::span<const std::string_view> words(ColorMixing) { return colorMixingWords; }

GradientTable::GradientTable(std::span<const GradientStop> stops, ColorMixing mixing)
{
    std::vector<GradientStop> sorted(stops.begin(), stops.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const GradientStop& a, const GradientStop& b) { return a.position < b.position; });
    if (sorted.empty())
        return;
    size_t next = 0; // the first stop past the entry
    for (int i = 0; i <= intervals; ++i) {
        const double t = static_cast<double>(i) / intervals;
        while (next < sorted.size() && sorted[next].position <= t)
            ++next;
        const GradientStop& low = sorted[next == 0 ? 0 : next - 1];
        const GradientStop& high = sorted[std::min(next, sorted.size() - 1)];
        const double way = high.position - low.position;
        const double f = way > 0.0 && next > 0 ? std::clamp((t - low.position) / way, 0.0, 1.0) : 0.0;
        const glm::dvec3 color = mixing == ColorMixing::Oklab ? oklab::mixed(low.color, high.color, f) : glm::mix(low.color, high.color, f);
        m_entries[static_cast<size_t>(i)] = {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
                                            static_cast<float>(low.opacity + f * (high.opacity - low.opacity))};
    }
}

} // namespace mirrorball
