#pragma once

#include "image_io.h"

#include <cstdint>

/// What image_io and the module that links OpenImageIO agree on. The module is a shared library of its own, loaded on first need:
/// OpenImageIO brings 260 libraries, which cost 0.3 to 0.45 s to load, and most runs of the tool touch only .exr and .hdr.
/// Module and caller are always built together; the version catches a stale one.
namespace mirrorball::openimageio {

/// What of a file is read, and how. Plain values.
struct RawRequest {
    int part = 0;
    int level = 0;
    bool keepsEncoding = false; ///< colors as they are stored, for who knows their space better than the file
    Channels channels = Channels::Color;
};

/// One level of an image to write, either float or 8-bit samples.
struct RawLevel {
    int width = 0;
    int height = 0;
    int channels = 0;
    const float* floats = nullptr;
    const std::uint8_t* bytes = nullptr; ///< set: written as they are, floats ignored
};

/// Takes the bytes of the file that is being written, with its random access.
class Sink {
public:
    virtual ~Sink() = default;
    virtual void write(const void* bytes, size_t count) = 0;
    virtual std::uint64_t position() = 0;
    virtual void seek(std::uint64_t position) = 0;
};

struct Module {
    int version = 0;
    /// Rows as the file has them, not yet turned upright (info().orientation): linear Rec.709 unless the encoding is kept. Without opacity
    /// the colors that were drawn, whatever the alpha beside them; with it multiplied by it. info() has what was assumed of part, encoding
    /// and alpha. `format` is OpenImageIO's name of it, empty: by extension. @throws FileError
    std::unique_ptr<ImageReader> (*open)(const std::filesystem::path& path, const std::string& format, const RawRequest& request) = nullptr;
    /// One image goes into the sink. `named` is the target, for its extension and messages. @throws WorkError
    void (*write)(Sink& sink, const std::filesystem::path& named, const RawLevel& image, const WriteOptions& options) = nullptr;
    /// A mip chain goes into the existing file `temporary`: TIFF levels are appended by reading back, which no sink can do. @throws
    /// WorkError
    void (*writeMips)(const std::filesystem::path& temporary, const std::filesystem::path& named, const std::vector<RawLevel>& levels,
                      const WriteOptions& options) = nullptr;
};

inline constexpr int moduleVersion = 2;
inline constexpr const char* entryPoint = "mirrorballOpenImageIo"; ///< extern "C" const Module* entryPoint()

} // namespace mirrorball::openimageio
