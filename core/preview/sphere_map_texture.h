#pragma once

#include "gl_object.h"
#include "render_settings.h"

namespace mirrorball::preview {

/// A painted sphere map on the GPU: a 2D texture with the levels given, filtered along a footprint's longer side where the hardware can.
/// A pointer that comes back unchanged is the same map.
class SphereMapTexture {
public:
    /// @param role for messages, "sphere map" @throws InvalidArgument when there is no map or its levels do not halve; WorkError when it is
    /// larger than the GPU takes
    void update(const SphereMapChain& map, const char* role);
    void release();
    /// @param anisotropy most lookups along the longer side of a footprint that the hardware measures itself, where it can; 1: filtered
    /// evenly
    /// @param onlyLevel  the one level that lookups read, at most the last; empty: the one that fits the footprint
    void bind(GLuint unit, int anisotropy, std::optional<int> onlyLevel = {}) const;
    const SphereMapChain& source() const { return m_source; }

    /// Puts texels into one level of the map that is there, their upper left one at (x, y).
    void patch(const Image& texels, int x, int y, int level);

private:
    SphereMapChain m_source{};
    GlObject m_texture{};
};

} // namespace mirrorball::preview
