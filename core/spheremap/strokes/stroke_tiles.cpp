#include "stroke_tiles.h"

#include "core/sphere/parameterization.h"

#include <algorithm>

namespace mirrorball {

StrokeTiles::StrokeTiles(std::span<const Stroke> strokes, int size, const JobControl& job)
    : m_size(size), m_columns((size + TileSet::tileSize - 1) / TileSet::tileSize), m_job(job)
{
    validate(MapLayout{Parameterization::Sphere, size, 0});
    validate(strokes);
    m_tiles = std::make_unique<Tile[]>(static_cast<size_t>(m_columns) * static_cast<size_t>(m_columns));
    TileSet met(size);
    m_strokes.reserve(strokes.size());
    for (const Stroke& stroke : strokes) {
        m_strokes.push_back(texelStroke(stroke, size));
        met.add(m_strokes.back().tiles(size));
    }
    for (const int tile : met.list())
        m_tiles[static_cast<size_t>(tile)].meets = true;
}

bool StrokeTiles::canPaint(std::span<const Stroke> strokes)
{
    return std::none_of(strokes.begin(), strokes.end(), [](const Stroke& stroke) { return stroke.brush.mode == BrushMode::Smudge; });
}

const float* StrokeTiles::texel(int x, int y) const
{
    constexpr int edge = TileSet::tileSize;
    const int column = x / edge, row = y / edge;
    Tile& tile = m_tiles[static_cast<size_t>(row * m_columns + column)];
    if (!tile.meets)
        return nullptr;
    std::call_once(tile.painted, [&] {
        auto texels = std::make_unique<float[]>(static_cast<size_t>(edge) * edge * 4);
        const TexelRect rect{column * edge, row * edge, std::min((column + 1) * edge, m_size), std::min((row + 1) * edge, m_size)};
        paintTile(m_strokes, rect, texels.get(), edge, m_job);
        tile.texels = std::move(texels);
    });
    return tile.texels.get() + 4 * ((y - row * edge) * edge + (x - column * edge));
}

} // namespace mirrorball
