#include "repair.h"

#include <bit>
#include <cmath>
#include <vector>

namespace mirrorball {
namespace {

constexpr float largestHalf = 65504.0f;

/// One channel of one row: values[0], values[channels], ...
struct Strided {
    float* values;
    size_t width;
    size_t channels;
    float& operator[](size_t x) const { return values[x * channels]; }
};

/// Fills each run of NaN between the finite values on its two sides. Infinities are no neighbours: a NaN beside a sun is not a sun.
void interpolateNan(const Strided& row, const std::vector<float>& original)
{
    const size_t width = row.width;
    const auto nearest = [&](size_t x, size_t step) { // steps to the next finite value that way round; width if there is none
        size_t distance = 1;
        while (distance < width && !std::isfinite(original[(x + distance * step) % width]))
            ++distance;
        return distance;
    };
    for (size_t x = 0; x < width; ++x) {
        if (!std::isnan(original[x]))
            continue;
        const size_t right = nearest(x, 1);
        const size_t left = nearest(x, width - 1);
        if (right >= width) {
            row[x] = 0.0f;
            continue;
        }
        // The neighbours are read from the row, where a clamped negative is 0 already.
        const double a = row[(x + width - left) % width];
        const double b = row[(x + right) % width];
        row[x] = static_cast<float>(a + (b - a) * static_cast<double>(left) / static_cast<double>(left + right));
    }
}

RepairReport repairChannel(const Strided& row, NegativePolicy policy)
{
    RepairReport report;
    std::vector<float> original(row.width);
    for (size_t x = 0; x < row.width; ++x) {
        float& value = row[x];
        original[x] = value;
        if (std::isnan(value)) {
            ++report.nan;
        } else if (std::isinf(value)) {
            ++(value > 0.0f ? report.positiveInfinity : report.negativeInfinity);
            value = value > 0.0f ? largestHalf : policy == NegativePolicy::Clamp ? 0.0f : -largestHalf;
        } else if (value < 0.0f) {
            ++report.negative;
            if (policy == NegativePolicy::Clamp) {
                ++report.clamped;
                value = 0.0f;
            }
        }
    }
    if (report.nan > 0)
        interpolateNan(row, original);
    return report;
}

/// Whether a row has anything to count or mend. Nearly all rows have not, and this test runs at memory speed: seen as an integer, a
/// float that is finite and not negative lies below infinity's bits.
bool isSound(const float* values, size_t count)
{
    constexpr auto infinity = 0x7f800000u;
    unsigned unsound = 0;
    for (size_t i = 0; i < count; ++i)
        unsound |= std::bit_cast<std::uint32_t>(values[i]) >= infinity ? 1u : 0u;
    return unsound == 0;
}

RepairReport repairRows(float* values, size_t width, size_t rows, size_t channels, NegativePolicy policy)
{
    RepairReport report;
    for (size_t y = 0; y < rows; ++y, values += width * channels)
        if (!isSound(values, width * channels))
            for (size_t c = 0; c < channels; ++c)
                report += repairChannel({values + c, width, channels}, policy);
    return report;
}

} // namespace

RepairReport& RepairReport::operator+=(const RepairReport& other)
{
    nan += other.nan;
    positiveInfinity += other.positiveInfinity;
    negativeInfinity += other.negativeInfinity;
    negative += other.negative;
    clamped += other.clamped;
    return *this;
}

RepairReport repairRows(float* rgb, int width, int rows, NegativePolicy policy)
{
    return repairRows(rgb, static_cast<size_t>(width), static_cast<size_t>(rows), 3, policy);
}

RepairReport repair(Image& image, NegativePolicy policy)
{
    return repairRows(image.texels.data(), static_cast<size_t>(image.width), static_cast<size_t>(image.height),
                      static_cast<size_t>(image.channels), policy);
}

std::string describe(const RepairReport& report)
{
    std::string text;
    if (report.nonFinite() > 0)
        text = std::to_string(report.nan) + " NaN, " + std::to_string(report.positiveInfinity + report.negativeInfinity) +
               " infinite values repaired";
    const auto append = [&](std::int64_t count, const char* what) {
        if (count > 0)
            text += (text.empty() ? "" : "; ") + std::to_string(count) + what;
    };
    append(report.clamped, " negative values clamped to 0");
    append(report.negative - report.clamped, " negative values kept");
    return text.empty() ? "no NaN, infinite or negative values" : text;
}

} // namespace mirrorball
