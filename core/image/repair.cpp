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

/// Fills each run of NaN between the finite values on its two sides; there must be one. Infinities are no neighbors: a NaN beside a sun is
/// not a sun.
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
        // The neighbors are read from the row, where a clamped negative is 0 already.
        const double a = row[(x + width - left) % width];
        const double b = row[(x + right) % width];
        row[x] = static_cast<float>(a + (b - a) * static_cast<double>(left) / static_cast<double>(left + right));
    }
}

/// @return whether the row has a finite value; without one it is left as it is
bool repairChannel(const Strided& row, NegativePolicy policy, RepairReport& report)
{
    bool isAlive = false;
    std::int64_t nan = 0;
    std::vector<float> original(row.width);
    for (size_t x = 0; x < row.width; ++x) {
        const float value = original[x] = row[x];
        isAlive = isAlive || std::isfinite(value);
        if (std::isnan(value))
            ++nan;
        else if (std::isinf(value))
            ++(value > 0.0f ? report.positiveInfinity : report.negativeInfinity);
        else if (value < 0.0f)
            ++report.negative;
    }
    report.nan += nan;
    if (!isAlive) {
        ++report.filledRows;
        return false;
    }
    for (size_t x = 0; x < row.width; ++x) {
        float& value = row[x];
        if (std::isinf(value)) {
            value = value > 0.0f ? largestHalf : policy == NegativePolicy::Clamp ? 0.0f : -largestHalf;
        } else if (value < 0.0f && policy == NegativePolicy::Clamp) {
            ++report.clamped;
            value = 0.0f;
        }
    }
    if (nan > 0)
        interpolateNan(row, original);
    return true;
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

/// Gives the dead rows of one channel what lies between their neighbors.
void fillChannel(Image& image, int channel, const std::vector<DeadChannels>& dead)
{
    const auto isDead = [&](int y) { return (dead[static_cast<size_t>(y)] >> channel & 1u) != 0; };
    int above = -1;
    for (int y = 0; y < image.height; ++y) {
        if (!isDead(y)) {
            above = y;
            continue;
        }
        int below = y;
        while (below < image.height && isDead(below))
            ++below;
        for (; y < below; ++y)
            for (int x = 0; x < image.width; ++x)
                image.texel(x, y)[channel] =
                    betweenRows(above < 0 ? nullptr : image.texel(x, above) + channel,
                                below == image.height ? nullptr : image.texel(x, below) + channel, y - above, below - y);
        --y;
    }
}

} // namespace

RepairReport& RepairReport::operator+=(const RepairReport& other)
{
    nan += other.nan;
    positiveInfinity += other.positiveInfinity;
    negativeInfinity += other.negativeInfinity;
    negative += other.negative;
    clamped += other.clamped;
    filledRows += other.filledRows;
    return *this;
}

float betweenRows(const float* above, const float* below, int fromAbove, int toBelow)
{
    if (!above || !below)
        return above ? *above : below ? *below : 0.0f;
    return static_cast<float>(*above + (static_cast<double>(*below) - *above) * fromAbove / (fromAbove + toBelow));
}

DeadChannels repairRow(float* row, int width, int channels, NegativePolicy policy, RepairReport& report)
{
    const auto n = static_cast<size_t>(width), c = static_cast<size_t>(channels);
    DeadChannels dead = 0;
    if (!isSound(row, n * c))
        for (size_t channel = 0; channel < c; ++channel)
            dead |= repairChannel({row + channel, n, c}, policy, report) ? 0u : 1u << channel;
    return dead;
}

RepairReport repair(Image& image, NegativePolicy policy)
{
    RepairReport report;
    std::vector<DeadChannels> dead;
    DeadChannels any = 0;
    for (int y = 0; y < image.height; ++y) {
        dead.push_back(repairRow(image.row(y), image.width, image.channels, policy, report));
        any |= dead.back();
    }
    for (int c = 0; c < image.channels; ++c)
        if ((any >> c & 1u) != 0)
            fillChannel(image, c, dead);
    return report;
}

std::string describe(const RepairReport& report)
{
    std::string text;
    if (report.nonFinite() > 0)
        text = std::to_string(report.nan) + " NaN, " + std::to_string(report.positiveInfinity + report.negativeInfinity) +
               " infinite values repaired";
    if (report.filledRows > 0)
        text += ", " + std::to_string(report.filledRows) + " rows of a channel filled from their neighbors";
    const auto append = [&](std::int64_t count, const char* what) {
        if (count > 0)
            text += (text.empty() ? "" : "; ") + std::to_string(count) + what;
    };
    append(report.clamped, " negative values clamped to 0");
    append(report.negative - report.clamped, " negative values kept");
    return text.empty() ? "no NaN, infinite or negative values" : text;
}

} // namespace mirrorball
