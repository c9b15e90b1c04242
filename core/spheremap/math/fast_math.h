#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

/// Elementary functions for loops over many texels: without branches, calls or tables, so that the compiler makes vector code of them.
/// The same bits on every machine that rounds as IEEE 754 says. Their error is far below what a texel shows.
namespace mirrorball::fast {

inline float floor(float x)
{
    const float t = static_cast<float>(static_cast<std::int32_t>(x)); // |x| < 2^31
    return t - static_cast<float>(t > x);
}

/// 2^x for x in [-126, 126], clamped to that; relative error below 3e-7.
inline float exp2(float x)
{
    x = std::min(std::max(x, -126.0f), 126.0f);
    const float n = floor(x + 0.5f);
    const float f = x - n; // [-1/2, 1/2]
    float p = 1.5403530e-4f;
    p = p * f + 1.3333558e-3f;
    p = p * f + 9.6181291e-3f;
    p = p * f + 5.5504109e-2f;
    p = p * f + 2.4022651e-1f;
    p = p * f + 6.9314718e-1f;
    p = p * f + 1.0f;
    return p * std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23);
}

/// log2(x) for normal x > 0; absolute error below 4e-6 times max(1, |log2 x|).
inline float log2(float x)
{
    const auto bits = std::bit_cast<std::int32_t>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)): x = 2^e m.
    const std::int32_t shifted = bits - 0x3f3504f3;
    const auto e = static_cast<float>(shifted >> 23);
    const float m = std::bit_cast<float>((shifted & 0x007fffff) + 0x3f3504f3);
    const float t = (m - 1.0f) / (m + 1.0f), t2 = t * t; // atanh series: |t| < 0.172
    return e + t * (2.88539008f + t2 * (0.96179669f + t2 * (0.57707802f + t2 * 0.41219859f)));
}

/// x^p for x >= 0 and p >= 0; 0^0 = 1.
inline float pow(float x, float p) { return exp2(p * log2(std::max(x, 1e-37f))); }

inline float exp(float x) { return exp2(x * 1.44269504f); }

/// Angle of (x, y) in (-pi, pi]; absolute error below 4e-6. (0, 0) gives 0.
inline float atan2(float y, float x)
{
    const float ax = std::fabs(x), ay = std::fabs(y);
    const float t = std::min(ax, ay) / std::max(std::max(ax, ay), 1e-37f), s = t * t;
    float r = -0.01172120f;
    r = r * s + 0.05265332f;
    r = r * s - 0.11643287f;
    r = r * s + 0.19354346f;
    r = r * s - 0.33262347f;
    r = r * s + 0.99997726f;
    r *= t;
    r = ay > ax ? 1.57079637f - r : r;
    r = x < 0.0f ? 3.14159274f - r : r;
    return y < 0.0f ? -r : r;
}

/// Absolute error below 5e-6 for |x| < 1000.
inline float cos(float x)
{
    float t = x * 0.159154943f;
    t -= floor(t + 0.5f);                                             // turns, in [-1/2, 1/2)
    const float s = 6.28318531f * (0.25f - std::fabs(t)), s2 = s * s; // cos x = sin s, s in [-pi/2, pi/2]
    return s * (1.0f - s2 * (1.66666667e-1f - s2 * (8.33333333e-3f - s2 * (1.98412698e-4f - s2 * 2.75573192e-6f))));
}

/// A number in [0, 1) that looks random, from two integers and a seed.
inline float hash(std::int32_t i, std::int32_t j, std::int32_t seed)
{
    auto h = static_cast<std::uint32_t>(i) * 0x8da6b343u + static_cast<std::uint32_t>(j) * 0xd8163841u +
             static_cast<std::uint32_t>(seed) * 0xcb1ab31fu;
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    h ^= h >> 16;
    return static_cast<float>(static_cast<std::int32_t>(h >> 8)) * (1.0f / 16777216.0f);
}

/// Smooth noise in [0, 1] of wavelength about 1: hash() at the integers, blended by smoothstep.
inline float noise(float x, float y, std::int32_t seed)
{
    const float fx = floor(x), fy = floor(y);
    const auto i = static_cast<std::int32_t>(fx), j = static_cast<std::int32_t>(fy);
    float u = x - fx, v = y - fy;
    u = u * u * (3.0f - 2.0f * u);
    v = v * v * (3.0f - 2.0f * v);
    const float low = hash(i, j, seed) + u * (hash(i + 1, j, seed) - hash(i, j, seed));
    const float high = hash(i, j + 1, seed) + u * (hash(i + 1, j + 1, seed) - hash(i, j + 1, seed));
    return low + v * (high - low);
}

} // namespace mirrorball::fast
