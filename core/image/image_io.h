#pragma once

#include "image.h"
#include "probe_reading.h"

#include "core/base/job.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Reading and writing image files. What is written is a row of the table of formats (image_format.h), chosen by the extension; what is
/// read is told by its first bytes, and may also be whatever else OpenImageIO reads. OpenImageIO is loaded on first need: linking it costs
/// every process a third of a second.
namespace mirrorball {

/// What a file says about itself, read from its header only.
struct ImageFileInfo {
    std::filesystem::path path{};
    std::string format{}; ///< "openexr", "hdr", "tiff", "png", ...
    int width = 0;
    int height = 0;
    int offsetX = 0; ///< of OpenEXR's data window in its display window
    int offsetY = 0;
    std::int64_t blackTexels = 0; ///< outside the data window
    int orientation = 1;          ///< as stored, by Exif's numbers: 1 upright, 3 upside down, 6 and 8 on a side; readers undo it
    int channels = 0;             ///< as stored in the file
    std::string sampleType{};     ///< "float", "half", "uint8", ...
    bool tiled = false;
    int levels = 1; ///< mip levels in the file
    int parts = 1;
    std::string compression{};
    std::string envmap{};                            ///< OpenEXR's envmap attribute: "latlong", "cube" or empty
    std::map<std::string, std::string> attributes{}; ///< the strings that Mirrorball wrote ("mirrorball:parameterization", ...)
    std::vector<Assumption> assumed{};               ///< what its reader decided, and how certainly
    std::vector<std::string> notes{};                ///< what of it a user should know, a clause each
};

/// What the rows of a reader hold: red, green, blue, or these and the opacity by which they are multiplied.
enum class Channels { Color, ColorAndOpacity };
/// Floats a texel.
inline int texelFloats(Channels channels) { return channels == Channels::Color ? 3 : 4; }

/// A file opened for reading top to bottom in blocks of rows, as linear float: what a probe of any size streams through.
/// Gray is copied to three channels, a file in another encoding (8-bit sRGB) is linearized, and a turned one is set upright.
/// Without opacity, colors are those that were drawn: what integer formats hold beside an alpha; of formats that multiply by it (OpenEXR),
/// what they hold.
class ImageReader {
public:
    virtual ~ImageReader() = default;
    virtual const ImageFileInfo& info() const = 0;
    /// Reads rows [firstRow, firstRow + rows) into `texels`, texelFloats() floats a texel. Rows are asked for in increasing order.
    /// @throws FileError when the file is damaged or ends early
    virtual void readRows(int firstRow, int rows, float* texels) = 0;
};

/// Of `reading`, what concerns the file's texels: part, layer, window, color space.
/// @throws FileError for a missing, empty, damaged, absurdly large (over 2^30 texels; over 2^28 where the format has no
///         rows to be read by themselves) or unknown file, or one without what is asked for;
///         InvalidArgument for a color space that is unknown
std::unique_ptr<ImageReader> openImage(const std::filesystem::path& path, const ProbeReading& reading = {},
                                       Channels channels = Channels::Color);

/// All rows of a reader. @throws FileError, Cancelled
Image readAll(ImageReader& reader, const JobControl& job = {}, Channels channels = Channels::Color);

/// The whole image as linear RGB. @throws FileError, also for more than 2^28 texels
Image readImage(const std::filesystem::path& path, const JobControl& job = {});
/// The whole image. @throws FileError, InvalidArgument
Image readImage(const std::filesystem::path& path, const ProbeReading& reading, Channels channels, const JobControl& job = {});

/// A pass of a layered OpenEXR file (Blender's matcaps have `diffuse` and `specular`), as linear light. Nothing where the file has no pass
/// of that name, which no other format has. @throws FileError
std::optional<Image> readImagePass(const std::filesystem::path& path, const std::string& pass, Channels channels = Channels::Color,
                                   const JobControl& job = {});

enum class SampleType { Float, Half };

/// What the texels to be written are: linear radiance, multiplied by opacity where there is a fourth channel, or a picture already encoded
/// for a display (color.h), in [0, 1] and not multiplied, which only 8-bit formats take and which goes into them as it is.
enum class Encoding { Linear, Display };

/// What the bytes of a format of 8 bits a channel stand for, where linear light goes into it.
enum class ByteEncoding {
    Filmic, ///< a picture to look at: filmic tone curve, then sRGB (color.h)
    Srgb,   ///< clipped to [0, 1], then sRGB: what 8-bit textures are taken for
    Rgbe,   ///< radiance with a shared exponent or multiplier in alpha (container/packed_texel.h); .png only
    Rgbm,
    Rgbd,
    Rgbp,
};
std::span<const std::string_view> words(ByteEncoding); // filmic srgb rgbe rgbm rgbd rgbp

struct WriteOptions {
    SampleType sampleType = SampleType::Float;       ///< .exr and .tif; half is clamped to +-65504 first
    std::map<std::string, std::string> attributes{}; ///< stored where the format can hold strings (not .hdr)
    Encoding encoding = Encoding::Linear;
    ByteEncoding bytes = ByteEncoding::Filmic; ///< .png and its like; see checkBytes()
    int faces =
        1; ///< 6: the picture is the stacked faces of a cube, for a format that keeps those as such; levels then halve a face's edge
    int faceBorder = 0; ///< cube maps (map_file.h): texels of the neighbors around each face
};

/// Whether a file can hold the encoding. @throws InvalidArgument naming the formats that can
void checkBytes(const std::filesystem::path& path, ByteEncoding bytes);

/// Writes linear RGB. A fourth channel is left out where the format has none. .png is tone-mapped (color.h) and
/// sRGB-encoded unless options.bytes says otherwise; .hdr takes no
/// negative values (clamped to 0). The file appears whole or not at all: it is written under a temporary name beside the target and
/// renamed.
/// @throws InvalidArgument for an extension that cannot be written, or that takes no display picture; WorkError when writing fails
void writeImage(const std::filesystem::path& path, const Image& image, const WriteOptions& options = {});

/// A picture of a file that holds several.
struct ImagePassData {
    std::string name{};
    Image image{}; ///< three channels
};

/// Writes pictures of one size into one file of a format that has passes (.exr).
/// @throws InvalidArgument for another format, or pictures that differ in size; WorkError when writing fails
void writePasses(const std::filesystem::path& path, const std::vector<ImagePassData>& passes, const WriteOptions& options = {});

/// Writes a mip chain, largest first, into one file; level i is half of level i-1 rounded down, at least 1.
/// The format's own chain may go on past the levels given (a stacked cube's 1 x 6): the remaining ones are filled with box averages.
/// @throws InvalidArgument where the format keeps no levels
void writeMips(const std::filesystem::path& path, const std::vector<Image>& levels, const WriteOptions& options = {});

/// The bytes of an 8-bit .png of a display picture (color.h), for pictures that go into other files.
std::string encodePng(const Image& display);

/// Reads one mip level of a file, as linear RGB. @throws FileError
Image readLevel(const std::filesystem::path& path, int level);

} // namespace mirrorball
