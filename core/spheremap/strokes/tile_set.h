#pragma once

#include "core/spheremap/math/texel_rect.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace mirrorball {

/// Which of a square map's tiles are meant. Tiles lie on a fixed grid, so that work which is done tile by tile gives the same bytes
/// whatever else is done with it.
class TileSet {
public:
    static constexpr int tileSize = 64; ///< texels

    explicit TileSet(int size) : m_size(size), m_columns((size + tileSize - 1) / tileSize)
    {
        m_tiles.resize(static_cast<size_t>(m_columns) * static_cast<size_t>(m_columns));
    }

    int tileCount() const { return m_columns * m_columns; }
    bool contains(int tile) const { return m_tiles[static_cast<size_t>(tile)] != 0; }
    void add(int tile) { m_tiles[static_cast<size_t>(tile)] = 1; }
    void addAll() { std::fill(m_tiles.begin(), m_tiles.end(), std::uint8_t{1}); }
    /// Every tile that a rectangle meets; its part outside the map counts for nothing.
    void add(const TexelRect& rect)
    {
        const TexelRect r = rect.intersected({0, 0, m_size, m_size});
        if (r.empty())
            return;
        for (int ty = r.y0 / tileSize; ty <= (r.y1 - 1) / tileSize; ++ty)
            for (int tx = r.x0 / tileSize; tx <= (r.x1 - 1) / tileSize; ++tx)
                add(ty * m_columns + tx);
    }
    void add(const TileSet& other)
    {
        for (size_t i = 0; i < m_tiles.size(); ++i)
            m_tiles[i] |= other.m_tiles[i];
    }
    bool meets(const TileSet& other) const
    {
        for (size_t i = 0; i < m_tiles.size(); ++i)
            if (m_tiles[i] & other.m_tiles[i])
                return true;
        return false;
    }
    bool containsAll(const TileSet& other) const
    {
        for (size_t i = 0; i < m_tiles.size(); ++i)
            if (other.m_tiles[i] && !m_tiles[i])
                return false;
        return true;
    }
    /// The texels of a tile, cut at the map's edge.
    TexelRect rect(int tile) const
    {
        const int x = tile % m_columns * tileSize, y = tile / m_columns * tileSize;
        return {x, y, std::min(x + tileSize, m_size), std::min(y + tileSize, m_size)};
    }
    /// The tiles meant, in order.
    std::vector<int> list() const
    {
        std::vector<int> tiles;
        for (int i = 0; i < tileCount(); ++i)
            if (contains(i))
                tiles.push_back(i);
        return tiles;
    }
    bool empty() const { return std::find(m_tiles.begin(), m_tiles.end(), std::uint8_t{1}) == m_tiles.end(); }
    /// The smallest rectangle around all of them.
    TexelRect bounds() const
    {
        TexelRect all;
        for (const int tile : list())
            all = all.united(rect(tile));
        return all;
    }

private:
    int m_size;
    int m_columns;
    std::vector<std::uint8_t> m_tiles;
};

} // namespace mirrorball
