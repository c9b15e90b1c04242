#include "openimageio_module.h"

#include "input_checks.h"
#include "picture_decoder.h"
#include "png_colors.h"

#include "core/base/error.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mirrorball::openimageio {
namespace {

constexpr int tileEdge = 64; ///< of the mip chains written here
constexpr const char* attributePrefix = "mirrorball:";

/// TIFF holds no attributes of free names: there they go, one a line, into the image description.
std::map<std::string, std::string> readAttributes(const OIIO::ImageSpec& spec)
{
    std::map<std::string, std::string> attributes;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString && attribute.name().string().starts_with(attributePrefix))
            attributes[attribute.name().string()] = attribute.get_string();
    std::istringstream lines(spec.get_string_attribute("ImageDescription"));
    for (std::string line; std::getline(lines, line);)
        if (const size_t equals = line.find('='); line.starts_with(attributePrefix) && equals != std::string::npos)
            attributes[line.substr(0, equals)] = line.substr(equals + 1);
    return attributes;
}

/// What the file says of its colors, as far as OpenImageIO tells.
StoredColors storedColors(const std::filesystem::path& path, const std::string& format, const OIIO::ImageSpec& spec, int colors)
{
    StoredColors said{.format = format, .isInteger = !spec.format.is_floating_point(), .isBytes = spec.format == OIIO::TypeUInt8};
    said.channels = colors;
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const float gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
    said.saysSo = "its header";
    if (OIIO::Strutil::istarts_with(space, "GammaCorrected") && gamma > 0.05f && gamma < 20.0f)
        said.exponent = gamma;
    else if (OIIO::Strutil::iequals(space, "Linear") || OIIO::Strutil::iequals(space, "scene_linear"))
        said.isLinear = true;
    else if (OIIO::Strutil::iequals(space, "sRGB") && spec.get_int_attribute("Exif:ColorSpace", 0) == 1) {
        said.isSrgb = true;
        said.saysSo = "Exif";
    } else if (OIIO::Strutil::iequals(space, "sRGB") && !said.isInteger) {
        said.isSrgb = true;
    }
    if (format == "png")
        readPngColors(path, said);
    const OIIO::ParamValue* const icc = spec.find_attribute("ICCProfile");
    if (icc && icc->type().basetype == OIIO::TypeDesc::UINT8) {
        const auto* const bytes = static_cast<const unsigned char*>(icc->data());
        said.iccProfile.assign(bytes, bytes + icc->type().size());
    }
    return said;
}

class Reader final : public ImageReader {
public:
    Reader(const std::filesystem::path& path, const std::string& format, const RawRequest& request) : m_request(request)
    {
        const std::string name = path.string();
        const std::string plugin = format.empty() ? path.extension().string().substr(1) : format;
        m_input = OIIO::ImageInput::create(plugin);
        OIIO::ImageSpec spec, hints;
        if (!m_input)
            throw FileError(name, "this is no image of a known format; export it as .exr or .hdr (" + oneLine(OIIO::geterror()) + ")");
        hints.attribute("oiio:UnassociatedAlpha", 1); // else it multiplies by it, in whatever encoding the file has
        if (!m_input->open(name, spec, hints))
            throw damaged(name);
        countLevels();
        const int level = request.level, part = request.part;
        if (part < 0 || part >= m_info.parts)
            throw FileError(name, "there is no part " + std::to_string(part) + " among its " + std::to_string(m_info.parts) +
                                      "; choose one of 0 to " + std::to_string(m_info.parts - 1));
        if (level < 0 || level >= m_info.levels)
            throw FileError(name, "there is no mip level " + std::to_string(level) + " among its " + std::to_string(m_info.levels) +
                                      "; ask for one it has");
        m_spec = m_input->spec(part, level);
        checkImageSize(name, m_spec.width, m_spec.height);
        if (m_spec.depth > 1 || m_spec.deep || m_spec.nchannels < 1 || m_spec.nchannels > 1024)
            throw FileError(name, "this is not a flat image; export it as one");
        m_info.path = path;
        m_info.format = m_input->format_name();
        m_info.width = m_spec.width;
        m_info.height = m_spec.height;
        m_info.channels = m_spec.nchannels;
        m_info.sampleType = m_spec.format.c_str();
        m_info.tiled = m_spec.tile_width > 0;
        m_info.compression = m_spec.get_string_attribute("compression");
        m_info.attributes = readAttributes(m_spec);
        m_info.orientation = std::clamp(m_spec.get_int_attribute("Orientation", 1), 1, 8);
        describeColors();
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const size_t count = static_cast<size_t>(m_info.width) * static_cast<size_t>(rows);
        m_samples.resize(count * static_cast<size_t>(m_info.channels));
        readSamples(firstRow, rows, m_samples.data());
        m_colors.resize(3 * count);
        const auto channels = static_cast<size_t>(m_info.channels);
        for (size_t i = 0; i < count; ++i)
            for (size_t c = 0; c < 3; ++c)
                m_colors[3 * i + c] = drawn(m_samples.data() + i * channels, channels < 3 ? 0 : c);
        if (!m_request.keepsEncoding)
            m_decoder->toLinear(m_colors.data(), count);
        if (m_request.channels == Channels::Color) {
            std::copy(m_colors.begin(), m_colors.end(), texels);
            return;
        }
        for (size_t i = 0; i < count; ++i) {
            const float alpha = m_alpha < 0 ? 1.0f : std::clamp(m_samples[i * channels + static_cast<size_t>(m_alpha)], 0.0f, 1.0f);
            for (size_t c = 0; c < 3; ++c)
                texels[4 * i + c] = m_colors[3 * i + c] * (m_isMultiplied && !m_isDivided ? 1.0f : alpha);
            texels[4 * i + 3] = alpha;
        }
    }

private:
    FileError damaged(const std::string& name) const
    {
        const std::string reason = oneLine(m_input->geterror());
        return FileError(name,
                         "the image is damaged (" + (reason.empty() ? "it cannot be decoded" : reason) + "); export or download it again");
    }

    void describeColors()
    {
        const bool isInteger = !m_spec.format.is_floating_point();
        m_alpha = m_spec.alpha_channel < m_spec.nchannels ? m_spec.alpha_channel : -1;
        if (m_alpha < 0 && m_spec.nchannels == 2)
            m_alpha = 1; // gray and alpha
        m_isMultiplied = m_alpha >= 0 && m_spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
        m_isDivided = m_isMultiplied && isInteger;
        m_decoder = std::make_unique<PictureDecoder>(storedColors(m_info.path, m_info.format, m_spec, m_info.channels < 3 ? 1 : 3));
        m_info.notes = m_decoder->notes();
        assume(m_info.assumed, m_decoder->assumption());
        assume(m_info.assumed, {"part", std::to_string(m_request.part), m_info.parts == 1 ? "the only one" : "the first, or asked for"});
        for (int i = 0; i < std::min(m_info.parts, 30); ++i)
            if (i != m_request.part)
                m_info.assumed.back().others.push_back(std::to_string(i));
        assume(m_info.assumed, {"alpha",
                                m_alpha < 0      ? "none"
                                : m_isDivided    ? "colors as drawn, divided by it"
                                : m_isMultiplied ? "colors are multiplied by it"
                                                 : "colors as drawn, not multiplied by it",
                                "the format's convention"});
    }

    /// A stored color without its alpha.
    float drawn(const float* texel, size_t channel) const
    {
        if (!m_isDivided)
            return texel[channel];
        const float alpha = texel[m_alpha];
        return alpha > 0.0f ? std::min(texel[channel] / alpha, 1.0f) : 0.0f;
    }

    void readSamples(int firstRow, int rows, float* samples)
    {
        const size_t rowFloats = static_cast<size_t>(m_info.width) * static_cast<size_t>(m_info.channels);
        if (!m_info.tiled) {
            const int top = m_spec.y + firstRow;
            if (!m_input->read_scanlines(m_request.part, m_request.level, top, top + rows, m_spec.z, 0, m_info.channels, OIIO::TypeFloat,
                                         samples))
                throw damaged(m_info.path.string());
            return;
        }
        for (int y = firstRow; y < firstRow + rows; ++y, samples += rowFloats) {
            if (y / m_spec.tile_height != m_heldTileRow)
                readTileRow(y / m_spec.tile_height, rowFloats);
            std::copy_n(m_held.data() + static_cast<size_t>(y % m_spec.tile_height) * rowFloats, rowFloats, samples);
        }
    }

    /// Of the part that is asked for, the levels; and the parts.
    void countLevels()
    {
        while (m_info.parts < 100 && m_input->seek_subimage(m_info.parts, 0))
            ++m_info.parts;
        while (m_info.levels < 32 && m_input->seek_subimage(m_request.part, m_info.levels))
            ++m_info.levels;
        static_cast<void>(m_input->geterror()); // the question past the last level leaves one
        m_input->seek_subimage(m_request.part, 0);
    }

    void readTileRow(int tileRow, size_t rowFloats)
    {
        const int top = m_spec.y + tileRow * m_spec.tile_height;
        const int bottom = std::min(top + m_spec.tile_height, m_spec.y + m_spec.height);
        m_heldTileRow = -1;
        m_held.resize(rowFloats * static_cast<size_t>(bottom - top));
        if (!m_input->read_tiles(m_request.part, m_request.level, m_spec.x, m_spec.x + m_spec.width, top, bottom, m_spec.z, m_spec.z + 1, 0,
                                 m_info.channels, OIIO::TypeFloat, m_held.data()))
            throw damaged(m_info.path.string());
        m_heldTileRow = tileRow;
    }

    RawRequest m_request;
    std::unique_ptr<OIIO::ImageInput> m_input;
    OIIO::ImageSpec m_spec;
    ImageFileInfo m_info{};
    std::unique_ptr<PictureDecoder> m_decoder;
    int m_alpha = -1;            ///< its channel
    bool m_isMultiplied = false; ///< the colors come multiplied by it
    bool m_isDivided = false;    ///< and are divided again
    int m_heldTileRow = -1;
    std::vector<float> m_held{}, m_samples{}, m_colors{};
};

std::unique_ptr<ImageReader> open(const std::filesystem::path& path, const std::string& format, const RawRequest& request)
{
    return std::make_unique<Reader>(path, format, request);
}

std::unique_ptr<OIIO::ImageOutput> createOutput(const std::filesystem::path& named)
{
    auto output = OIIO::ImageOutput::create(named.extension().string().substr(1));
    if (!output || !output->supports("ioproxy"))
        throw WorkError(named.string() + ": this OpenImageIO cannot write the format; write .exr (" + oneLine(OIIO::geterror()) + ")");
    return output;
}

/// OpenImageIO's view of a Sink. An error must not fly through libtiff or libpng, which are C: it is kept and thrown afterwards.
class SinkProxy final : public OIIO::Filesystem::IOProxy {
public:
    explicit SinkProxy(Sink& sink) : IOProxy("", Write), m_sink(sink) {}
    const char* proxytype() const override { return "sink"; }

    int64_t tell() override { return static_cast<int64_t>(m_sink.position()); }
    bool seek(int64_t offset) override
    {
        return guarded([&] { m_sink.seek(static_cast<std::uint64_t>(offset)); });
    }
    size_t write(const void* bytes, size_t count) override
    {
        if (!guarded([&] { m_sink.write(bytes, count); }))
            return 0;
        m_size = std::max(m_size, static_cast<size_t>(m_sink.position()));
        return count;
    }
    size_t size() const override { return m_size; }
    void rethrow() const
    {
        if (m_error)
            std::rethrow_exception(m_error);
    }

private:
    template <class Action>
    bool guarded(const Action& action)
    {
        if (m_error)
            return false;
        try {
            action();
        } catch (...) {
            m_error = std::current_exception();
        }
        return !m_error;
    }

    Sink& m_sink;
    size_t m_size = 0;
    std::exception_ptr m_error{};
};

OIIO::ImageSpec makeSpec(const RawLevel& level, const WriteOptions& options, bool mipped)
{
    const OIIO::TypeDesc floats = options.sampleType == SampleType::Half ? OIIO::TypeHalf : OIIO::TypeFloat;
    OIIO::ImageSpec spec(level.width, level.height, level.channels, level.bytes ? OIIO::TypeUInt8 : floats);
    spec.attribute("oiio:ColorSpace", level.bytes ? "sRGB" : "Linear");
    if (level.bytes)
        spec.attribute("oiio:UnassociatedAlpha", 1); // else the writer divides by the opacity, as if sRGB were linear
    spec.attribute("compression", "zip");
    spec.attribute("tiff:half", 1); // without it OpenImageIO writes floats where half is asked for
    spec.attribute("DateTime", ""); // else the TIFF writer puts the clock's time in, and no two files are alike
    if (mipped) {
        spec.tile_width = spec.tile_height = tileEdge;
        spec.attribute("textureformat", "Plain Texture"); // says that the directories of a TIFF file are mip levels
    }
    std::string description;
    for (const auto& [name, text] : options.attributes) {
        spec.attribute(name, text);
        if (name.starts_with(attributePrefix))
            description += name + "=" + text + "\n";
    }
    if (!description.empty())
        spec.attribute("ImageDescription", description);
    return spec;
}

bool writePixels(OIIO::ImageOutput& output, const RawLevel& level)
{
    return level.bytes ? output.write_image(OIIO::TypeUInt8, level.bytes) : output.write_image(OIIO::TypeFloat, level.floats);
}

/// Tile by tile, each filled to its edges: given a whole image, OpenImageIO leaves what it finds in memory beyond the picture.
bool writeTiles(OIIO::ImageOutput& output, const RawLevel& level)
{
    const auto channels = static_cast<size_t>(level.channels);
    std::vector<float> tile(tileEdge * tileEdge * channels);
    for (int top = 0; top < level.height; top += tileEdge)
        for (int left = 0; left < level.width; left += tileEdge) {
            for (int y = 0; y < tileEdge; ++y)
                for (int x = 0; x < tileEdge; ++x) {
                    const auto row = static_cast<size_t>(std::min(top + y, level.height - 1));
                    const auto column = static_cast<size_t>(std::min(left + x, level.width - 1));
                    std::copy_n(level.floats + (row * static_cast<size_t>(level.width) + column) * channels, channels,
                                tile.data() + static_cast<size_t>(y * tileEdge + x) * channels);
                }
            if (!output.write_tile(left, top, 0, OIIO::TypeFloat, tile.data()))
                return false;
        }
    return true;
}

WorkError writeError(const std::filesystem::path& named, const std::string& reason)
{
    return WorkError(named.string() + ": cannot be written: " + (reason.empty() ? "the disk may be full" : oneLine(reason)) +
                     "; free some space or write .exr");
}

void write(Sink& sink, const std::filesystem::path& named, const RawLevel& image, const WriteOptions& options)
{
    SinkProxy proxy(sink); // outlives the output, whose destructor may still write
    const auto output = createOutput(named);
    output->set_ioproxy(&proxy);
    const bool written = output->open(named.string(), makeSpec(image, options, false)) && writePixels(*output, image) && output->close();
    proxy.rethrow();
    if (!written)
        throw writeError(named, output->geterror());
}

void writeMips(const std::filesystem::path& temporary, const std::filesystem::path& named, const std::vector<RawLevel>& levels,
               const WriteOptions& options)
{
    const auto output = createOutput(named);
    const auto append = output->supports("mipmap") ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
    bool written = true;
    for (size_t i = 0; i < levels.size() && written; ++i)
        written = output->open(temporary.string(), makeSpec(levels[i], options, true), i == 0 ? OIIO::ImageOutput::Create : append) &&
                  writeTiles(*output, levels[i]);
    written = output->close() && written;
    if (!written)
        throw writeError(named, output->geterror());
    // libtiff tells nobody when its last directory does not fit on the disk; but then not one byte more fits either.
    const auto size = std::filesystem::file_size(temporary);
    if (!(std::ofstream(temporary, std::ios::binary | std::ios::app).put('\0').flush()))
        throw writeError(named, {});
    std::filesystem::resize_file(temporary, size);
}

const Module exported{moduleVersion, &open, &write, &writeMips};

} // namespace
} // namespace mirrorball::openimageio

extern "C" __attribute__((visibility("default"))) const mirrorball::openimageio::Module* mirrorballOpenImageIo()
{
    return &mirrorball::openimageio::exported;
}
