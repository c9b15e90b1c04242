#include "openimageio_loader.h"

#include "color.h"
#include "foreign_reader.h"
#include "image_format.h"
#include "openimageio_library.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

namespace mirrorball::openimageio {
namespace {

constexpr float largestHalf = 65504.0f;
struct Signature {
    std::string_view bytes;
    size_t offset;
    const char* format; ///< OpenImageIO's name
};

using namespace std::string_view_literals;

/// The formats that people have pictures in. Each more is one more decoder that files of strangers reach.
constexpr std::array<Signature, 14> signatures{{
    {"\x89PNG\r\n"sv, 0, "png"},
    {"\xff\xd8\xff"sv, 0, "jpeg"},
    {"II*\0"sv, 0, "tiff"},
    {"MM\0*"sv, 0, "tiff"},
    {"II+\0"sv, 0, "tiff"}, // BigTIFF
    {"MM\0+"sv, 0, "tiff"},
    {"BM"sv, 0, "bmp"},
    {"WEBP"sv, 8, "webp"},
    {"8BPS"sv, 0, "psd"},
    {"DDS "sv, 0, "dds"},
    {"ftyp"sv, 4, "heif"}, // and AVIF
    {"Pf\n"sv, 0, "pnm"},  // PFM, in which light probes are handed on
    {"PF\n"sv, 0, "pnm"},
    {"P6"sv, 0, "pnm"},
}};
constexpr std::string_view knownFormats = ".exr, .hdr, .png, .tif, .jpg, .webp, .bmp, .tga, .psd, .heic, .avif, .dds, .pfm or .ppm";

std::string lowerExtension(const std::filesystem::path& path)
{
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// A .tga file has no signature: its name says what it is, and its first bytes may not contradict.
bool looksLikeTarga(std::string_view bytes, const std::string& extension)
{
    constexpr std::string_view kinds("\1\2\3\11\12\13");
    return extension == ".tga" && bytes.size() > 2 && static_cast<unsigned char>(bytes[1]) < 2 && kinds.find(bytes[2]) != kinds.npos;
}

/// OpenImageIO's name of the format that the content is in; empty for none that is read.
std::string formatOf(std::string_view firstBytes, const std::string& extension)
{
    for (const Signature& signature : signatures)
        if (firstBytes.size() > signature.offset && firstBytes.substr(signature.offset).starts_with(signature.bytes))
            return signature.format;
    return looksLikeTarga(firstBytes, extension) ? "targa" : "";
}

/// Walks the chunks of a PNG file and compares their checksums: libpng reports damage on stderr, past everyone.
/// @throws FileError
void checkPng(const std::filesystem::path& path)
{
    const auto remainders = [] {
        std::array<std::uint32_t, 256> table{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            table[i] = i;
            for (int bit = 0; bit < 8; ++bit)
                table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xedb88320u : 0u);
        }
        return table;
    }();
    std::ifstream stream(path, std::ios::binary);
    const auto number = [&] {
        std::array<unsigned char, 4> b{};
        stream.read(reinterpret_cast<char*>(b.data()), 4);
        return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
    };
    std::string type(8, '\0');
    stream.read(type.data(), 8);
    if (type != "\x89PNG\r\n\x1a\n")
        stream.setstate(std::ios::failbit);
    std::vector<char> buffer(1 << 16);
    while (stream && type != "IEND") {
        std::uint64_t rest = std::uint64_t{number()} + 4; // the checksum covers the chunk's name and content
        std::uint32_t crc = ~0u;
        type.clear();
        while (stream && rest > 0) {
            stream.read(buffer.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(rest, buffer.size())));
            const auto count = static_cast<size_t>(stream.gcount());
            if (type.empty())
                type.assign(buffer.data(), std::min<size_t>(4, count));
            for (size_t i = 0; i < count; ++i)
                crc = remainders[(crc ^ static_cast<unsigned char>(buffer[i])) & 0xff] ^ crc >> 8;
            rest -= count;
        }
        if (number() != ~crc)
            stream.setstate(std::ios::failbit);
    }
    if (!stream)
        throw FileError(path.string(), "the PNG file is cut short or damaged; export or download it again");
}

/// Turns what the module reads into linear RGB.
class LinearReader final : public ImageReader {
public:
    explicit LinearReader(std::unique_ptr<RawReader> raw)
        : m_raw(std::move(raw)), m_isSrgb(m_raw->isSrgb()), m_isBytes(m_raw->info().sampleType == "uint8")
    {
        for (size_t i = 0; i < m_decodedBytes.size(); ++i)
            m_decodedBytes[i] = decodeSrgb(static_cast<float>(i) / 255.0f);
    }

    const ImageFileInfo& info() const override { return m_raw->info(); }

    void readRows(int firstRow, int rows, float* rgb) override
    {
        const size_t texels = static_cast<size_t>(info().width) * static_cast<size_t>(rows);
        const auto channels = static_cast<size_t>(info().channels);
        m_samples.resize(texels * channels);
        m_raw->readRows(firstRow, rows, m_samples.data());
        const bool grey = channels < 3; // two are grey and alpha
        for (size_t i = 0; i < texels; ++i)
            for (size_t c = 0; c < 3; ++c) {
                const float sample = m_samples[i * channels + (grey ? 0 : c)];
                rgb[3 * i + c] = m_isSrgb ? linear(sample) : sample;
            }
    }

private:
    float linear(float sample) const { return m_isBytes ? m_decodedBytes[toByte(sample)] : decodeSrgb(sample); }

    std::unique_ptr<RawReader> m_raw;
    bool m_isSrgb; ///< asked once: the answer is a search through the file's attributes
    bool m_isBytes;
    std::array<float, 256> m_decodedBytes{};
    std::vector<float> m_samples{};
};

class FileSink final : public Sink {
public:
    explicit FileSink(AtomicFile& file) : m_file(file) {}
    void write(const void* bytes, size_t count) override { m_file.write(bytes, count); }
    std::uint64_t position() override { return m_file.position(); }
    void seek(std::uint64_t position) override { m_file.seek(position); }

private:
    AtomicFile& m_file;
};

/// Keeps the bytes of a file in memory.
class MemorySink final : public Sink {
public:
    void write(const void* bytes, size_t count) override
    {
        m_bytes.resize(std::max(m_bytes.size(), m_at + count));
        std::copy_n(static_cast<const char*>(bytes), count, m_bytes.data() + m_at);
        m_at += count;
    }
    std::uint64_t position() override { return m_at; }
    void seek(std::uint64_t position) override { m_at = position; }
    std::string bytes() && { return std::move(m_bytes); }

private:
    std::string m_bytes{};
    size_t m_at = 0;
};

} // namespace

std::unique_ptr<ImageReader> open(const std::filesystem::path& path, std::string_view firstBytes, int level)
{
    std::string format = formatOf(firstBytes, lowerExtension(path));
    const ImageFormat* const named = findFormat(path);
    if (format.empty() && named && named->label == "PNG")
        format = "png"; // for checkPng() to refuse
    if (format.empty())
        throw FileError(path.string(), "this is no image of a known format; export it as " + std::string(knownFormats));
    if (format == "png")
        checkPng(path);
    return std::make_unique<LinearReader>(openForeign(path, format, level));
}

void write(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options)
{
    const bool floats = writableFormat(named).samples == StoredSamples::Float;
    std::vector<std::vector<std::uint8_t>> bytes;
    std::vector<std::vector<float>> clamped;
    std::vector<RawLevel> raw;
    for (const Image& image : levels) {
        raw.push_back({image.width, image.height, image.channels, image.texels.data(), nullptr});
        if (!floats) {
            const Image display = options.encoding == Encoding::Display
                                      ? image
                                      : toDisplay(image, 0.0, options.bytes == ByteEncoding::Srgb ? ToneCurve::None : ToneCurve::Filmic);
            bytes.emplace_back(display.texels.size());
            std::transform(display.texels.begin(), display.texels.end(), bytes.back().begin(), toByte);
            raw.back().bytes = bytes.back().data();
        } else if (options.sampleType == SampleType::Half) {
            clamped.push_back(image.texels);
            for (float& value : clamped.back())
                value = std::clamp(value, -largestHalf, largestHalf);
            raw.back().floats = clamped.back().data();
        }
    }
    if (raw.size() > 1) {
        module().writeMips(file.temporary(), named, raw, options);
        return;
    }
    FileSink sink(file);
    module().write(sink, named, raw.front(), options);
}

std::string encodePng(const Image& display)
{
    std::vector<std::uint8_t> bytes(display.texels.size());
    std::transform(display.texels.begin(), display.texels.end(), bytes.begin(), toByte);
    MemorySink sink;
    module().write(sink, "picture.png", {display.width, display.height, display.channels, nullptr, bytes.data()}, {});
    return std::move(sink).bytes();
}

} // namespace mirrorball::openimageio
