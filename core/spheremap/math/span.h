#pragma once

#include "vector_clones.h"

#include <algorithm>
#include <functional>

/// What layers work on: runs of texels of one row, a float array for each quantity, so that loops over them become vector code and stay in
/// the first cache while a whole stack of layers passes over them.
namespace mirrorball {

inline constexpr int spanLength = 256; ///< most texels in a run

/// Where the texels of a run lie. The position in the disc (sphere/disc.h) is the normal of the ball that the disc is a picture of.
/// Texels outside the disc stand for the nearest point of the rim: so color continues past the edge, and a lookup at the rim never reads
/// anything else.
struct DiscSpan {
    int count = 0;
    int column = 0; ///< of the first texel, in the map
    int row = 0;
    float texel = 0.0f;                ///< edge of a texel in radii of the disc: what edges are smoothed over
    alignas(64) float x[spanLength];   ///< unit normal, to the right
    alignas(64) float y[spanLength];   ///< up
    alignas(64) float z[spanLength];   ///< towards the viewer, 0 at the rim
    alignas(64) float rho[spanLength]; ///< distance from the center, at most 1
};

/// Colors of the texels of a run: linear RGB and opacity.
struct ColorSpan {
    alignas(64) float r[spanLength];
    alignas(64) float g[spanLength];
    alignas(64) float b[spanLength];
    alignas(64) float a[spanLength];
};

/// A layer made ready: fills a run with its colors, which are *not* multiplied by the opacity. Pure; called from many threads at once.
using SpanGenerator = std::function<void(const DiscSpan& at, ColorSpan& out)>;
/// An adjustment made ready: changes the colors of what lies below, which are not multiplied by the opacity either.
using SpanAdjustment = std::function<void(const DiscSpan& at, ColorSpan& below)>;

inline void fill(ColorSpan& out, int count, float r, float g, float b)
{
    std::fill_n(out.r, count, r);
    std::fill_n(out.g, count, g);
    std::fill_n(out.b, count, b);
}

/// 0 below 0, 1 above 1, 3u^2 - 2u^3 between.
inline float smooth(float u)
{
    u = std::min(std::max(u, 0.0f), 1.0f);
    return u * u * (3.0f - 2.0f * u);
}

/// What part of a texel lies on the inner side of an edge: smooth() over the edge's own width, or over one and a half texels where that is
/// more, so that no edge is harder than the grid can show. Resolution-independent but for that.
class Edge {
public:
    /// @param softness, texel  in radii of the disc, or whatever unit the distances come in
    Edge(float softness, float texel) : m_slope(1.0f / std::max(softness, 1.5f * texel)) {}
    /// @param distance  from the edge, positive inside
    float operator()(float distance) const { return smooth(distance * m_slope + 0.5f); }

private:
    float m_slope;
};

} // namespace mirrorball
