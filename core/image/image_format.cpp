#include "image_format.h"

#include "exr_format.h"
#include "hdr_format.h"
#include "image_readers.h"
#include "openimageio_loader.h"

#include "container/babylon_env.h"
#include "container/container_file.h"
#include "container/dds.h"
#include "container/ktx1.h"
#include "container/ktx2.h"
#include "container/png_codec.h"

#include "core/base/error.h"

#include <algorithm>
#include <cctype>

namespace mirrorball {

namespace {

std::string lowerExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::unique_ptr<ImageReader> openHdr(OpenedFile file, int level, const ProbeReading& reading, Channels channels)
{
    const std::filesystem::path& path = file.path();
    checkNoLayer(path, reading);
    if (level != 0)
        throw FileError(path.string(), "a Radiance picture has no mip levels; ask for level 0");
    if (partNumber(path, reading) != 0)
        throw FileError(path.string(), "a Radiance picture has one part; ask for part 0");
    return hdr::open(std::move(file), reading, channels);
}

std::unique_ptr<ImageReader> openTexture(OpenedFile file, int level, const ProbeReading& reading, Channels channels)
{
    checkNoLayer(file.path(), reading);
    return withOpacity(openContainer(std::move(file), level), channels);
}

void writeExr(AtomicFile& file, const std::filesystem::path&, const std::vector<Image>& levels, const WriteOptions& options)
{
    if (levels.size() == 1)
        exr::write(file, levels.front(), options);
    else
        exr::writeMips(file, levels, options);
}

void writeHdr(AtomicFile& file, const std::filesystem::path&, const std::vector<Image>& levels, const WriteOptions&)
{
    hdr::write(file, levels.front());
}

/// A row that OpenImageIO reads and writes as a display picture.
ImageFormat displayFormat(std::string_view label, std::vector<std::string_view> extensions, const CompressionRatios& ratios,
                          double writingSeconds = 1e-7)
{
    return {.label = label,
            .extensions = std::move(extensions),
            .alpha = true,
            .ratios = ratios,
            .writingSeconds = writingSeconds,
            .needsOpenImageIo = true,
            .write = &openimageio::write};
}

ImageFormat withAttributes(ImageFormat format)
{
    format.attributes = true;
    return format;
}

ImageFormat withWriter(ImageFormat format, decltype(ImageFormat::write) write)
{
    format.write = write;
    return format;
}

ImageFormat withoutAlpha(ImageFormat format)
{
    format.alpha = false;
    return format;
}

/// A .png is a picture to look at, or radiance packed into its four channels.
void writePng(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options)
{
    if (options.encoding == Encoding::Display || options.bytes == ByteEncoding::Filmic || options.bytes == ByteEncoding::Srgb) {
        openimageio::write(file, named, levels, options);
        return;
    }
    const Image& image = levels.front();
    const auto form = static_cast<PackedColor>(static_cast<int>(options.bytes) - static_cast<int>(ByteEncoding::Rgbe));
    const std::string bytes = png::encode(png::packed(image, form));
    file.write(bytes.data(), bytes.size());
}

/// A row of a texture container. One without `write` is made by exports for its engine only, which know what else is in it.
ImageFormat containerFormat(std::string_view label, std::vector<std::string_view> extensions, bool (*recognizes)(std::string_view),
                            decltype(ImageFormat::write) write = nullptr)
{
    return {.label = label,
            .extensions = std::move(extensions),
            .samples = StoredSamples::Float,
            .half = true,
            .levels = true,
            .faces = true,
            .recognizes = recognizes,
            .open = &openTexture,
            .write = write};
}

// Ratios: means over four 1k probes (studio, sky, night, interior) as cube and latlong of 256, `smooth` filtered with phong 50, and over
// the built-in sphere maps at 256. OpenImageIO writes the other formats through its streams too, but leaves half a file behind when it
// fails. Writing: CPU times of `filter` to cubes of phong 100 of a photographed sky, 512 less 128.
std::vector<ImageFormat> makeFormats()
{
    std::vector<ImageFormat> formats{
        {.label = "OpenEXR",
         .extensions = {".exr"},
         .samples = StoredSamples::Float,
         .half = true,
         .levels = true,
         .alpha = true,
         .attributes = true,
         .ratios = {1.0, 1.0, 1.0},
         .halfRatios = {0.6, 0.27, 0.31},
         .writingSeconds = 8e-8,
         .recognizes = &exr::hasSignature,
         .open = &exr::open,
         .write = &writeExr,
         .writeRows = &exr::writeRows,
         .writePasses = &exr::writePasses},
        {.label = "Radiance HDR",
         .extensions = {".hdr", ".pic", ".rgbe"},
         .samples = StoredSamples::Rgbe,
         .ratios = {0.78, 0.55, 0.78},
         .writingSeconds = 3e-8,
         .recognizes = &hdr::hasSignature,
         .open = &openHdr,
         .write = &writeHdr},
        {.label = "TIFF",
         .extensions = {".tif", ".tiff", ".tx"},
         .samples = StoredSamples::Float,
         .half = true,
         .levels = true,
         .alpha = true,
         .attributes = true,
         .ratios = {0.72, 0.56, 0.72},
         .halfRatios = {0.6, 0.27, 0.31},
         .writingSeconds = 4.3e-7,
         .needsOpenImageIo = true,
         .write = &openimageio::write},
        withWriter(withAttributes(displayFormat("PNG", {".png"}, {0.38, 0.12, 0.19}, 2e-7)), &writePng),
        withAttributes(withoutAlpha(displayFormat("JPEG", {".jpg", ".jpeg"}, {0.13, 0.04, 0.1}, 7e-8))),
        displayFormat("WebP", {".webp"}, {0.09, 0.014, 0.06}, 2e-7),
        withAttributes(displayFormat("TGA", {".tga"}, {0.92, 0.6, 0.5}, 1.5e-7)),
        displayFormat("BMP", {".bmp"}, {}),
        withoutAlpha(displayFormat("PPM", {".ppm"}, {}, 1e-6)),
        containerFormat("KTX", {".ktx"}, &ktx1::hasSignature, &writeKtx1),
        containerFormat("KTX 2", {".ktx2"}, &ktx2::hasSignature, &writeKtx2),
        containerFormat("DDS", {".dds"}, &dds::hasSignature, &writeDds),
        containerFormat("Babylon environment", {".env"}, &babylon_env::hasSignature),
    };
    return formats;
}

} // namespace

const std::vector<ImageFormat>& imageFormats()
{
    static const std::vector<ImageFormat> formats = makeFormats();
    return formats;
}

const ImageFormat* findFormat(const std::filesystem::path& path)
{
    const std::string extension = lowerExtension(path);
    for (const ImageFormat& format : imageFormats())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
            return &format;
    return nullptr;
}

const ImageFormat& writableFormat(const std::filesystem::path& path)
{
    const ImageFormat* const format = findFormat(path);
    if (format && format->write)
        return *format;
    const std::string extension = lowerExtension(path);
    throw InvalidArgument(path.string() +
                          (extension.empty() ? ": has no extension that tells the format"
                                             : ": no image can be written with the extension \"" + extension + "\"") +
                          "; use .exr, .hdr, .tif or .png");
}

bool isWritable(const std::filesystem::path& path)
{
    const ImageFormat* const format = findFormat(path);
    return format && format->write;
}

std::string writtenExtensions()
{
    std::string list;
    for (const ImageFormat& format : imageFormats())
        if (format.write)
            list.append(list.empty() ? "" : " ").append(format.extensions.front());
    return list;
}

const ImageFormat& passFormat(const std::filesystem::path& path)
{
    const ImageFormat* const format = findFormat(path);
    if (!format || !format->writePasses)
        throw InvalidArgument(path.string() + ": only .exr files hold passes");
    return *format;
}

bool holdsMips(const std::filesystem::path& path)
{
    const ImageFormat* const format = findFormat(path);
    return format && format->write && format->levels;
}

std::string_view sampleWord(const ImageFormat& format, SampleType type)
{
    switch (format.samples) {
    case StoredSamples::Float:
        return format.half && type == SampleType::Half ? "half" : "float";
    case StoredSamples::Rgbe:
        return "rgbe";
    case StoredSamples::Byte:
        break;
    }
    return "uint8";
}

int texelBytes(const ImageFormat& format, SampleType type, int channels)
{
    switch (format.samples) {
    case StoredSamples::Float:
        return channels * (format.half && type == SampleType::Half ? 2 : 4);
    case StoredSamples::Rgbe:
        return 4;
    case StoredSamples::Byte:
        break;
    }
    return channels;
}

} // namespace mirrorball
