#pragma once

#include "core/spheremap/math/span.h"

#include "core/image/image.h"

#include <memory>
#include <vector>

namespace mirrorball {

/// An RGB picture of a disc, inscribed in its square, to be read at any size: its halvings are made once. With a fourth channel, opacity,
/// its colors are multiplied by it.
class DiscPicture {
public:
    DiscPicture() = default;
    explicit DiscPicture(Image picture);

    /// The level to read where a texel of the map is `texel` radii wide.
    const Image& levelFor(double texel) const;
    bool empty() const { return m_levels.empty(); }
    int size() const { return m_levels.front().width; }
    /// That its texels hold.
    size_t bytes() const;

private:
    std::vector<Image> m_levels{};
};

/// Reads a run of texels off a picture: colors into r, g, b, and where it has opacity that into a, the colors not multiplied by it. The
/// position is (x, y) times `scale`, turned by (cosine, sine).
struct DiscLookup {
    float scale = 1.0f; ///< below 1 keeps away from the picture's rim
    float cosine = 1.0f, sine = 0.0f;
    void read(const Image& level, const DiscSpan& at, ColorSpan& out) const;
};

} // namespace mirrorball
