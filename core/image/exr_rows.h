#pragma once

#include "exr_channels.h"
#include "exr_stream.h"
#include "image_io.h"

#include <ImathBox.h>
#include <ImfMultiPartInputFile.h>

#include <memory>

namespace mirrorball::exr {

/// Where the rows of one level come from: scanlines, tiles, or luminance and chroma. Rows count from the top of the level's data window.
class RowSource {
public:
    virtual ~RowSource() = default;
    /// Reads rows into interleaved floats, texelFloats(channels) a texel. @throws what OpenEXR throws
    virtual void read(int firstRow, int rows, float* texels) = 0;
    /// The level's data window.
    virtual Imath::Box2i window() const = 0;
};

/// Opens one level of a picture. `levels` becomes the number of levels there are.
/// @throws FileError for luminance and chroma that cannot be read; what OpenEXR throws
struct OpenedRows {
    std::unique_ptr<RowSource> rows{}; ///< null where there is no such level
    int levels = 1;
};
OpenedRows openRows(FileStream& stream, Imf::MultiPartInputFile& file, const Picture& picture, Channels channels, int level);

} // namespace mirrorball::exr
