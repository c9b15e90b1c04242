#include "play_canvas_atlas.h"

#include "png_codec.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cassert>

namespace mirrorball::play_canvas_atlas {

glm::dvec3 direction(const Rectangle& r, double i, double j)
{
    const double u = (i - 0.5) / (r.width - 2), v = (std::clamp(j, 1.0, r.height - 2.0) - 0.5) / (r.height - 2);
    return directionFromLonLat(pi - 2.0 * pi * u, pi / 2.0 - pi * v);
}

std::string write(const Image& atlas, PackedColor form)
{
    assert(atlas.width == size && atlas.height == size && atlas.channels == 3);
    return png::encode(png::packed(atlas, form));
}

Image read(std::string_view bytes, const std::string& name, PackedColor form)
{
    const png::Picture picture = png::decode(bytes, name, 1LL * size * size);
    if (picture.width != size || picture.height != size)
        throw FileError(name, "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                                  " texels; an envAtlas has 512 x 512");
    Image atlas(size, size, 3);
    for (size_t i = 0; i < picture.texels.size(); ++i) {
        const glm::vec3 rgb = unpackColor(form, picture.texels[i]);
        std::copy_n(&rgb.x, 3, atlas.texels.data() + 3 * i);
    }
    return atlas;
}

} // namespace mirrorball::play_canvas_atlas
