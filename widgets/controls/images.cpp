#include "images.h"

#include "core/image/color.h"

namespace mirrorball::studio {

QImage toQImage(const Image& picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGBA8888);
    for (int y = 0; y < picture.height; ++y) {
        uchar* out = image.scanLine(y);
        const float* in = picture.row(y);
        for (int x = 0; x < picture.width; ++x, out += 4, in += picture.channels) {
            for (int c = 0; c < 3; ++c)
                out[c] = toByte(in[picture.channels < 3 ? 0 : c]);
            out[3] = picture.channels > 3 ? toByte(in[3]) : 255;
        }
    }
    // Painting wants it premultiplied; a conversion here, on the worker, saves one at every paint.
    return image.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
}

} // namespace mirrorball::studio
