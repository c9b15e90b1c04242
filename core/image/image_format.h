#pragma once

#include "image_io.h"

#include "core/base/atomic_file.h"
#include "core/base/opened_file.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// The table of image formats: one row says all that anybody asks of a format - checks of names, writers, dialogs, estimates,
/// descriptions of what was written. A new format is a reader and a writer, and one row.
namespace mirrorball {

struct PictureRows;

/// What the texels of a file are.
enum class StoredSamples {
    Float, ///< linear light, 32-bit floats, or 16-bit ones where the format has them
    Rgbe,  ///< linear light, three mantissas of 8 bits that share an exponent
    Byte,  ///< a display picture of 8 bits a channel, sRGB-encoded
};

/// Size of a file over that of its texels: what compression leaves, on average.
struct CompressionRatios {
    double plain = 1.0;   ///< an environment as it is
    double smooth = 1.0;  ///< a filtered one
    double painted = 1.0; ///< a painted sphere map
};

struct ImageFormat {
    std::string_view label;                     ///< "OpenEXR"
    std::vector<std::string_view> extensions{}; ///< in lower case, with the dot; the first is the one that files get
    StoredSamples samples = StoredSamples::Byte;
    bool half = false;       ///< SampleType::Half is stored as such
    bool levels = false;     ///< a mip chain fits into one file
    bool faces = false;      ///< the six faces of a cube are kept as such, see WriteOptions::faces
    bool alpha = false;      ///< a fourth channel is kept
    bool attributes = false; ///< strings are kept beside the texels, see WriteOptions::attributes
    CompressionRatios ratios{};
    CompressionRatios halfRatios{};
    double writingSeconds = 5e-8;  ///< CPU time of encoding a texel, compressing it and handing it to the system, about
    bool needsOpenImageIo = false; ///< to be written; loading it costs more than most pictures, see openimageio::loadingSeconds()

    /// Whether a file that begins with these bytes is of this format. Null: left to OpenImageIO, which knows the signatures of its formats.
    bool (*recognizes)(std::string_view firstBytes) = nullptr;
    /// Null as recognizes is.
    std::unique_ptr<ImageReader> (*open)(OpenedFile file, int level, const ProbeReading& reading, Channels channels) = nullptr;
    /// Writes a picture, or all levels of one, largest first: more than one where `levels`, and then the whole chain. `named` is the
    /// target, for messages. Null: the format is only read.
    void (*write)(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels,
                  const WriteOptions& options) = nullptr;
    /// A picture whose rows are made as they are written. Null: the format wants the whole.
    void (*writeRows)(AtomicFile& file, const PictureRows& picture, const WriteOptions& options) = nullptr;
    /// Several pictures of one size as passes. Null: the format has none.
    void (*writePasses)(AtomicFile& file, const std::vector<ImagePassData>& passes, const WriteOptions& options) = nullptr;
};

/// All rows, in the order in which they are offered.
const std::vector<ImageFormat>& imageFormats();

/// The row of a file's extension, in any case; null for an extension that is in none.
const ImageFormat* findFormat(const std::filesystem::path& path);

/// The row of a file that is to be written. @throws InvalidArgument for an extension that cannot be written: names some that can
const ImageFormat& writableFormat(const std::filesystem::path& path);

/// Whether writableFormat() has a row.
bool isWritable(const std::filesystem::path& path);

/// The first extension of each format that is written: ".exr .hdr .tif ...".
std::string writtenExtensions();

/// The row of a file that is to hold passes. @throws InvalidArgument for a format that has none
const ImageFormat& passFormat(const std::filesystem::path& path);

/// Whether a mip chain fits into one file of this name.
bool holdsMips(const std::filesystem::path& path);

/// The type of a stored sample in one word: "float", "half", "rgbe" or "uint8".
std::string_view sampleWord(const ImageFormat& format, SampleType type);

/// Bytes of a texel before compression.
int texelBytes(const ImageFormat& format, SampleType type, int channels = 3);

} // namespace mirrorball
