#include "stroke_canvas.h"

#include "core/sphere/parameterization.h"

#include <algorithm>

namespace mirrorball {

namespace {

void copyTiles(const Image& from, Image& to, const TileSet& tiles)
{
    for (const int tile : tiles.list()) {
        const TexelRect r = tiles.rect(tile);
        for (int y = r.y0; y < r.y1; ++y)
            std::copy_n(from.texel(r.x0, y), static_cast<size_t>(r.width()) * 4, to.texel(r.x0, y));
    }
}

void clearTiles(Image& image, const TileSet& tiles)
{
    for (const int tile : tiles.list()) {
        const TexelRect r = tiles.rect(tile);
        for (int y = r.y0; y < r.y1; ++y)
            std::fill_n(image.texel(r.x0, y), static_cast<size_t>(r.width()) * 4, 0.0f);
    }
}

/// Whether `longer` is `stroke` with the pen gone on.
bool continues(const Stroke& longer, const Stroke& stroke)
{
    return longer.points.size() >= stroke.points.size() && longer.brush == stroke.brush && longer.symmetry == stroke.symmetry &&
           std::equal(stroke.points.begin(), stroke.points.end(), longer.points.begin());
}

MapLayout checked(int size)
{
    const MapLayout layout{Parameterization::Sphere, size, 0};
    validate(layout);
    return layout;
}

} // namespace

StrokeCanvas::StrokeCanvas(int size) : m_image(checked(size).size, size, 4), m_painted(size) {}

TexelRect StrokeCanvas::update(std::span<const Stroke> strokes, const JobControl& job)
{
    validate(strokes);
    try {
        return advance(strokes, job).bounds();
    } catch (...) {
        *this = StrokeCanvas(size());
        throw;
    }
}

TileSet StrokeCanvas::advance(std::span<const Stroke> strokes, const JobControl& job)
{
    const size_t shorter = std::min(m_strokes.size(), strokes.size());
    const size_t same = static_cast<size_t>(
        std::mismatch(m_strokes.begin(), m_strokes.begin() + static_cast<std::ptrdiff_t>(shorter), strokes.begin()).first -
        m_strokes.begin());
    TileSet dirty(size());
    if (same == m_strokes.size() && same == strokes.size())
        return dirty;

    const bool penGoesOn = same + 1 == m_strokes.size() && same + 1 == strokes.size() && continues(strokes[same], m_strokes[same]);
    const size_t touchesBefore = penGoesOn ? m_texelStrokes[same].touches() : 0;
    TileSet gone(size());
    for (size_t i = same; i < m_strokes.size(); ++i)
        gone.add(m_texelStrokes[i].tiles(size()));
    // The base must not hold strokes that go; and when strokes are only added, it takes all that were there.
    if (same == m_strokes.size() && same > 0) {
        TileSet tiles(size());
        for (size_t i = m_baseCount; i < same; ++i)
            tiles.add(m_texelStrokes[i].tiles(size()));
        if (m_base.empty())
            m_base = Image(size(), size(), 4);
        copyTiles(m_image, m_base, tiles);
        m_baseCount = same;
    } else if (same == 0) {
        settle();
    } else if (same < m_baseCount) {
        setBase(same, gone, job);
    }

    const bool onlyAdded = penGoesOn || same == m_strokes.size();
    m_strokes.resize(same);
    m_strokes.insert(m_strokes.end(), strokes.begin() + static_cast<std::ptrdiff_t>(same), strokes.end());
    m_texelStrokes.resize(same);
    for (size_t i = same; i < strokes.size(); ++i) {
        m_texelStrokes.push_back(texelStroke(strokes[i], size()));
        dirty.add(m_texelStrokes.back().tiles(size(), i == same ? touchesBefore : 0));
    }
    if (!penGoesOn)
        dirty.add(gone);
    if (!onlyAdded)
        m_painted = TileSet(size());
    for (size_t i = onlyAdded ? same : 0; i < m_texelStrokes.size(); ++i)
        m_painted.add(m_texelStrokes[i].tiles(size()));

    const std::span<const TexelStroke> above(m_texelStrokes.begin() + static_cast<std::ptrdiff_t>(m_baseCount), m_texelStrokes.end());
    const TileSet work = closeForSmudging(dirty, above, size());
    if (m_base.empty())
        clearTiles(m_image, work);
    else
        copyTiles(m_base, m_image, work);
    paintTiles(m_image, above, work, job);
    return dirty;
}

void StrokeCanvas::settle()
{
    m_base = Image();
    m_baseCount = 0;
}

/// Takes the base back to the first `count` of the strokes it holds.
/// @param tiles  those in which they differ
void StrokeCanvas::setBase(size_t count, const TileSet& tiles, const JobControl& job)
{
    const std::span<const TexelStroke> kept(m_texelStrokes.data(), count);
    const TileSet work = closeForSmudging(tiles, kept, size());
    Image& scratch = m_base;
    clearTiles(scratch, work);
    paintTiles(scratch, kept, work, job);
    m_baseCount = count;
}

} // namespace mirrorball
