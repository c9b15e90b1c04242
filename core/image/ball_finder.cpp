#include "ball_finder.h"

#include "color.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mirrorball {

namespace {

/// Logarithmic brightness, one channel.
Image logarithms(const Image& picture)
{
    double mean = 0.0;
    const size_t texels = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    Image logs(picture.width, picture.height, 1);
    for (size_t i = 0; i < texels; ++i) {
        const float* t = picture.texels.data() + i * static_cast<size_t>(picture.channels);
        logs.texels[i] = static_cast<float>(std::max(luminance({t[0], t[1], t[2]}), 0.0));
        mean += logs.texels[i] / static_cast<double>(texels);
    }
    const auto floor = static_cast<float>(std::max(0.02 * mean, 1e-12)); // what is darker is black
    for (float& value : logs.texels)
        value = std::log2(value + floor);
    return logs;
}

/// Means over squares of `step` texels.
Image reduced(const Image& logs, int step)
{
    Image small(logs.width / step, logs.height / step, 1);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            float sum = 0.0f;
            for (int j = 0; j < step; ++j)
                for (int i = 0; i < step; ++i)
                    sum += *logs.texel(x * step + i, y * step + j);
            *small.texel(x, y) = sum / static_cast<float>(step * step);
        }
    return small;
}

float at(const Image& logs, const glm::dvec2& p)
{
    const int x = std::clamp(static_cast<int>(std::floor(p.x - 0.5)), 0, logs.width - 2);
    const int y = std::clamp(static_cast<int>(std::floor(p.y - 0.5)), 0, logs.height - 2);
    const float fx = static_cast<float>(std::clamp(p.x - 0.5 - x, 0.0, 1.0)), fy = static_cast<float>(std::clamp(p.y - 0.5 - y, 0.0, 1.0));
    return std::lerp(std::lerp(*logs.texel(x, y), *logs.texel(x + 1, y), fx),
                     std::lerp(*logs.texel(x, y + 1), *logs.texel(x + 1, y + 1), fx), fy);
}

constexpr double goodEdge = 1.0; ///< a factor of 2 across two texels

/// The mean change across the circle, over what of it lies in the picture; 0 where that is less than three quarters.
double slopeAcross(const Image& logs, const Circle& circle, int places)
{
    double sum = 0.0;
    int seen = 0;
    for (int i = 0; i < places; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / places;
        const glm::dvec2 n(std::cos(angle), std::sin(angle)), in = circle.center + (circle.radius - 1.0) * n,
                                                              out = circle.center + (circle.radius + 1.0) * n;
        if (out.x < 0.0 || out.y < 0.0 || out.x > logs.width || out.y > logs.height)
            continue;
        ++seen;
        sum += std::min<double>(std::abs(at(logs, out) - at(logs, in)), goodEdge);
    }
    return 4 * seen < 3 * places ? 0.0 : sum / seen;
}

/// Steps to better circles until steps of `finest` find none.
Circle refined(const Image& logs, Circle best, double step, double finest, int places)
{
    double score = slopeAcross(logs, best, places);
    while (step >= finest) {
        Circle next = best;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dr = -1; dr <= 1; ++dr) {
                    const Circle tried{best.center + step * glm::dvec2(dx, dy), best.radius + step * dr};
                    if (const double found = slopeAcross(logs, tried, places); found > score) {
                        score = found;
                        next = tried;
                    }
                }
        if (next.center == best.center && next.radius == best.radius)
            step *= 0.5;
        best = next;
    }
    return best;
}

} // namespace

std::optional<Circle> findBall(const Image& picture)
{
    constexpr int coarseEdge = 160;
    const int shorter = std::min(picture.width, picture.height);
    if (shorter < 16)
        return std::nullopt;
    const Image logs = logarithms(picture);
    const int step = std::max(1, shorter / coarseEdge);
    const Image small = step == 1 ? logs : reduced(logs, step);
    const int edge = std::min(small.width, small.height);
    std::vector<double> scores;
    Circle best;
    double highest = 0.0;
    for (double radius = 0.15 * edge; radius <= 0.52 * edge; radius += 2.0)
        for (double y = 0.3 * small.height; y <= 0.7 * small.height; y += 2.0)
            for (double x = 0.3 * small.width; x <= 0.7 * small.width; x += 2.0) {
                const double score = slopeAcross(small, {{x, y}, radius}, 48);
                scores.push_back(score);
                if (score > highest) {
                    highest = score;
                    best = {{x, y}, radius};
                }
            }
    if (scores.empty())
        return std::nullopt;
    std::nth_element(scores.begin(), scores.begin() + static_cast<std::ptrdiff_t>(scores.size() / 2), scores.end());
    best = refined(small, best, 1.0, 0.25, 180);
    if (const double score = slopeAcross(small, best, 180); score < 0.1 || score < 3.0 * scores[scores.size() / 2])
        return std::nullopt;
    if (step == 1)
        return best;
    return refined(logs, {best.center * static_cast<double>(step), best.radius * step}, 0.5 * step, 0.25, 720);
}

} // namespace mirrorball
