#pragma once

#include "image_io.h"

#include <cstdint>

/// What image_io and the module that links OpenImageIO agree on. The module is a shared library of its own, loaded on first need:
/// OpenImageIO brings 260 libraries, which cost 0.3 to 0.45 s to load, and most runs of the tool touch only .exr and .hdr.
/// Module and caller are always built together; the version catches a stale one.
namespace mirrorball::openimageio {

/// Rows as the file holds them: info().channels floats a texel, integers scaled to [0, 1], alpha premultiplied.
class RawReader {
public:
    virtual ~RawReader() = default;
    virtual const ImageFileInfo& info() const = 0;
    virtual bool isSrgb() const = 0; ///< colour values are sRGB-encoded
    /// @throws FileError
    virtual void readRows(int firstRow, int rows, float* samples) = 0;
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
    /// `format` is OpenImageIO's name of it, empty: by extension. @throws FileError
    std::unique_ptr<RawReader> (*open)(const std::filesystem::path& path, const std::string& format, int level) = nullptr;
    /// One image goes into the sink. `named` is the target, for its extension and messages. @throws WorkError
    void (*write)(Sink& sink, const std::filesystem::path& named, const RawLevel& image, const WriteOptions& options) = nullptr;
    /// A mip chain goes into the existing file `temporary`: TIFF levels are appended by reading back, which no sink can do. @throws
    /// WorkError
    void (*writeMips)(const std::filesystem::path& temporary, const std::filesystem::path& named, const std::vector<RawLevel>& levels,
                      const WriteOptions& options) = nullptr;
};

inline constexpr int moduleVersion = 1;
inline constexpr const char* entryPoint = "mirrorballOpenImageIo"; ///< extern "C" const Module* entryPoint()

} // namespace mirrorball::openimageio
