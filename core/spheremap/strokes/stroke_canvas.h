#pragma once

#include "stroke_raster.h"

namespace mirrorball {

/// The raster of a list of strokes while an artist works on it: the same bytes as paintStrokes(), but a change evaluates again only the
/// tiles that it touched.
///
/// It keeps the raster, and one more without the strokes since the last one began: the pen's next points are painted over that, so a frame
/// costs the dabs of the stroke at hand, however many strokes lie below. Undoing that stroke costs a copy; undoing further
/// evaluates the tiles of the stroke that goes.
class StrokeCanvas {
public:
    /// @throws InvalidArgument naming the size
    explicit StrokeCanvas(int size);

    /// Brings the raster to a list of strokes, which may differ from the last one in any way.
    /// @return the texels that may have changed; empty when nothing has
    /// @throws InvalidArgument as validate() does, with nothing changed; Cancelled, after which the next update starts afresh
    TexelRect update(std::span<const Stroke> strokes, const JobControl& job = {});

    /// Gives back what only further painting needs. The next change evaluates its tiles from the first stroke on.
    void settle();

    const std::vector<Stroke>& strokes() const { return m_strokes; }
    int size() const { return m_image.width; }
    const Image& image() const { return m_image; }
    /// Bounds of everything painted: outside them the raster is transparent.
    TexelRect bounds() const { return m_painted.bounds(); }

private:
    TileSet advance(std::span<const Stroke> strokes, const JobControl& job);
    void setBase(size_t count, const TileSet& tiles, const JobControl& job);

    std::vector<Stroke> m_strokes{};
    std::vector<TexelStroke> m_texelStrokes{};
    Image m_base{}; ///< the first m_baseCount strokes; empty while that is none
    size_t m_baseCount = 0;
    Image m_image{}; ///< all strokes
    TileSet m_painted;
};

} // namespace mirrorball
