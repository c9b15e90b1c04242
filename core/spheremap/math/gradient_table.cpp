#include "gradient_table.h"

#include "oklab.h"

#include <algorithm>
#include <cstring>

namespace mirrorball {

namespace {
using namespace std::string_view_literals;
constexpr std::array colorMixingWords{"oklab"sv, "linear"sv};

using Color __attribute__((vector_size(16))) = float;

Color loaded(const GradientTable::Entry& entry)
{
    Color color;
    std::memcpy(&color, &entry, sizeof color);
    return color;
}

void store(const Color& four, float* to) { std::memcpy(to, &four, sizeof four); }
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

/// A table's entry is one vector; four of them are turned so that each channel of the run is one.
MIRRORBALL_VECTOR_CLONES void GradientTable::look(int count, const float* t, ColorSpan& out) const
{
    alignas(64) float part[spanLength];
    alignas(64) int entry[spanLength];
    for (int i = 0; i < count; ++i) {
        const float x = std::min(1.0f, std::max(0.0f, t[i])) * static_cast<float>(intervals);
        entry[i] = std::min(static_cast<int>(x), intervals - 1);
        part[i] = x - static_cast<float>(entry[i]);
    }
    const auto at = [&](int i) {
        const Color p = loaded(m_entries[static_cast<size_t>(entry[i])]), q = loaded(m_entries[static_cast<size_t>(entry[i]) + 1]);
        return p + part[i] * (q - p);
    };
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        const Color a = at(i), b = at(i + 1), c = at(i + 2), d = at(i + 3);
        const Color abLow = __builtin_shufflevector(a, b, 0, 4, 1, 5), abHigh = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Color cdLow = __builtin_shufflevector(c, d, 0, 4, 1, 5), cdHigh = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        store(__builtin_shufflevector(abLow, cdLow, 0, 1, 4, 5), out.r + i);
        store(__builtin_shufflevector(abLow, cdLow, 2, 3, 6, 7), out.g + i);
        store(__builtin_shufflevector(abHigh, cdHigh, 0, 1, 4, 5), out.b + i);
        store(__builtin_shufflevector(abHigh, cdHigh, 2, 3, 6, 7), out.a + i);
    }
    for (; i < count; ++i) {
        const Color color = at(i);
        out.r[i] = color[0];
        out.g[i] = color[1];
        out.b[i] = color[2];
        out.a[i] = color[3];
    }
}

} // namespace mirrorball
