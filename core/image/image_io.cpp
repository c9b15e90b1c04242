#include "image_io.h"

#include "exr_format.h"
#include "image_format.h"
#include "image_readers.h"
#include "input_checks.h"
#include "opacity.h"
#include "openimageio_loader.h"
#include "picture_levels.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/opened_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace mirrorball {
namespace {

constexpr int blockTexels = 1 << 20; ///< read at a time: small enough to stop soon, large enough for all threads

/// What a file is, is told by its first bytes; its name is asked only where a format has no signature.
std::unique_ptr<ImageReader> openStored(const std::filesystem::path& path, int level, const ProbeReading& reading, Channels channels)
{
    OpenedFile file(path);
    for (const ImageFormat& format : imageFormats())
        if (format.recognizes && format.recognizes(file.firstBytes()))
            return format.open(std::move(file), level, reading, channels);
    checkNoLayer(path, reading);
    return openimageio::open(
        path, file.firstBytes(),
        {.part = partNumber(path, reading), .level = level, .keepsEncoding = !reading.colorSpace.empty(), .channels = channels});
}

std::unique_ptr<ImageReader> openLevel(const std::filesystem::path& path, int level, const ProbeReading& reading = {},
                                       Channels channels = Channels::Color)
{
    std::unique_ptr<ImageReader> reader = upright(openStored(path, level, reading, channels), channels);
    return reading.colorSpace.empty() ? std::move(reader) : inColorSpace(std::move(reader), reading.colorSpace, channels);
}

/// The chain down to 1 x 1; of a cube's faces those that are given. @throws InvalidArgument for a level of the wrong size
std::vector<Image> fullChain(const std::filesystem::path& path, const std::vector<Image>& levels, int faces)
{
    std::vector<Image> chain = levels;
    for (size_t i = 1; i < levels.size(); ++i) {
        const Image& larger = levels[i - 1];
        if (levels[i].width != std::max(1, larger.width / 2) || levels[i].height != faces * std::max(1, larger.height / faces / 2) ||
            levels[i].channels != larger.channels || (larger.width == 1 && larger.height == faces))
            throw InvalidArgument(path.string() + ": mip level " + std::to_string(i) + " is " + std::to_string(levels[i].width) + " x " +
                                  std::to_string(levels[i].height) + "; it must be half of the level before, rounded down");
    }
    while (faces == 1 && (chain.back().width > 1 || chain.back().height > 1))
        chain.push_back(boxHalved(chain.back(), {.threads = 1}));
    return chain;
}

void checkWritable(const std::filesystem::path& path, const Image& image)
{
    if (image.empty() || (image.channels != 1 && image.channels != 3 && image.channels != 4))
        throw InvalidArgument(path.string() + ": an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                              " texels and " + std::to_string(image.channels) + " channels cannot be written; 1, 3 or 4 channels can");
}

} // namespace

std::span<const std::string_view> words(ByteEncoding)
{
    static constexpr std::array<std::string_view, 6> all{"filmic", "srgb", "rgbe", "rgbm", "rgbd", "rgbp"};
    return all;
}

void checkBytes(const std::filesystem::path& path, ByteEncoding bytes)
{
    const ImageFormat& format = writableFormat(path);
    const bool packed = bytes != ByteEncoding::Filmic && bytes != ByteEncoding::Srgb;
    const std::string word(wordOf(bytes));
    if (format.samples != StoredSamples::Byte)
        throw InvalidArgument("--encode: '" + word + "' is for formats of 8 bits a channel; " + path.filename().string() +
                              " holds linear light as it is, so leave it out");
    if (packed && format.extensions.front() != ".png")
        throw InvalidArgument("--encode: '" + word + "' needs four channels without loss; write a .png");
}

Image readAll(ImageReader& reader, const JobControl& job, Channels channels)
{
    const int width = reader.info().width;
    const int height = reader.info().height;
    if (static_cast<long long>(width) * height > maxTexels)
        throw FileError(reader.info().path.string(),
                        "its " + std::to_string(width) + " x " + std::to_string(height) +
                            " texels are more than the 2^28 that are held at once; convert it to a smaller map first");
    const auto rowFloats = static_cast<size_t>(texelFloats(channels)) * static_cast<size_t>(width);
    Image image;
    image.channels = texelFloats(channels);
    image.width = width;
    image.height = height;
    // Reserved but touched only as rows arrive: a damaged file costs no more memory than the rows it really holds.
    image.texels.reserve(rowFloats * static_cast<size_t>(height));
    const int blockRows = std::max(1, blockTexels / width);
    for (int y = 0; y < height; y += blockRows) {
        job.checkStop();
        const int rows = std::min(blockRows, height - y);
        image.texels.resize(rowFloats * static_cast<size_t>(y + rows));
        reader.readRows(y, rows, image.row(y));
        if (job.progress)
            job.progress(static_cast<float>(y + rows) / static_cast<float>(height));
    }
    return image;
}

std::unique_ptr<ImageReader> openImage(const std::filesystem::path& path, const ProbeReading& reading, Channels channels)
{
    return openLevel(path, 0, reading, channels);
}

Image readImage(const std::filesystem::path& path, const JobControl& job) { return readAll(*openLevel(path, 0), job); }

Image readImage(const std::filesystem::path& path, const ProbeReading& reading, Channels channels, const JobControl& job)
{
    return readAll(*openLevel(path, 0, reading, channels), job, channels);
}

std::string encodePng(const Image& display) { return openimageio::encodePng(display); }

std::optional<Image> readImagePass(const std::filesystem::path& path, const std::string& pass, Channels channels, const JobControl& job)
{
    OpenedFile file(path);
    if (!exr::hasSignature(file.firstBytes()))
        return std::nullopt;
    const std::unique_ptr<ImageReader> reader = exr::openPass(std::move(file), pass, channels);
    if (!reader)
        return std::nullopt;
    return readAll(*reader, job, channels);
}

Image readLevel(const std::filesystem::path& path, int level) { return readAll(*openLevel(path, level)); }

void writeImage(const std::filesystem::path& path, const Image& image, const WriteOptions& options)
{
    checkWritable(path, image);
    const ImageFormat& format = writableFormat(path);
    if (options.encoding == Encoding::Display && format.samples != StoredSamples::Byte)
        throw InvalidArgument(path.string() + ": holds linear values, not a display picture; use .png");
    AtomicFile file(path);
    format.write(file, path, {image.channels == 4 && !format.alpha ? withoutOpacity(image) : image}, options);
    file.commit();
}

void writePasses(const std::filesystem::path& path, const std::vector<ImagePassData>& passes, const WriteOptions& options)
{
    const ImageFormat& format = passFormat(path);
    if (passes.empty())
        throw InvalidArgument(path.string() + ": there are no passes to write; give at least one");
    for (const ImagePassData& pass : passes) {
        checkWritable(path, pass.image);
        if (pass.image.width != passes.front().image.width || pass.image.height != passes.front().image.height || pass.image.channels != 3)
            throw InvalidArgument(path.string() + ": passes must be of one size and have three channels; " + pass.name + " is another");
    }
    AtomicFile file(path);
    format.writePasses(file, passes, options);
    file.commit();
}

void writeMips(const std::filesystem::path& path, const std::vector<Image>& levels, const WriteOptions& options)
{
    const ImageFormat& format = writableFormat(path);
    if (!format.levels)
        throw InvalidArgument(path.string() + ": this format keeps no mip levels; write .exr or .tif, or one file a level");
    if (levels.empty())
        throw InvalidArgument(path.string() + ": there are no mip levels to write; give at least one");
    for (const Image& level : levels)
        checkWritable(path, level);
    const std::vector<Image> chain = fullChain(path, levels, options.faces);
    AtomicFile file(path);
    format.write(file, path, chain, options);
    file.commit();
}

} // namespace mirrorball
