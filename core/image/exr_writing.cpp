#include "exr_format.h"

#include "exr_threads.h"
#include "input_checks.h"
#include "picture_rows.h"

#include "core/base/error.h"

#include <ImfChannelList.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>

namespace mirrorball::exr {
namespace {

using Imath::V2i;

constexpr int tileEdge = 64; ///< of the mip chains written here

/// OpenEXR's view of an AtomicFile.
class OutputStream final : public Imf::OStream {
public:
    explicit OutputStream(AtomicFile& file) : Imf::OStream("the output file"), m_file(file) {}
    void write(const char bytes[], int count) override { m_file.write(bytes, static_cast<size_t>(count)); }
    std::uint64_t tellp() override { return m_file.position(); }
    void seekp(std::uint64_t position) override { m_file.seek(position); }

private:
    AtomicFile& m_file;
};

std::vector<std::string> channelNames(int channels)
{
    if (channels == 1)
        return {"Y"};
    return channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"R", "G", "B", "A"};
}

/// Whether deflate finds anything to save. Values that came from half floats or RGBE end in zero bits; results of a sum, such as a
/// filtered map, fill all 23 bits of the mantissa with noise. Measured on a filtered 128 x 768 float cube: ZIP 42 ms and 97 % of the
/// size, PIZ 76 ms and 89 %, none 4 ms; on an RGBE probe of 1024 x 512: ZIP 107 ms and 27 %, PIZ 38 ms and 21 %, none 18 ms.
bool compresses(const Image& image, const WriteOptions& options)
{
    if (options.sampleType == SampleType::Half)
        return true;
    const auto isShort = [](float value) { return (std::bit_cast<std::uint32_t>(value) & 0xfff) == 0; };
    return 2 * std::count_if(image.texels.begin(), image.texels.end(), isShort) >= static_cast<std::ptrdiff_t>(image.texels.size());
}

/// @param sample  the picture, or a smaller one of it
Imf::Header makeHeader(int width, int height, const Image& sample, const WriteOptions& options)
{
    Imf::Header header(width, height);
    header.compression() = compresses(sample, options) ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
    for (const std::string& name : channelNames(sample.channels))
        header.channels().insert(name, Imf::Channel(options.sampleType == SampleType::Half ? Imf::HALF : Imf::FLOAT));
    for (const auto& [name, text] : options.attributes) {
        if (name == "envmap")
            Imf::addEnvmap(header, text == "cube" ? Imf::ENVMAP_CUBE : Imf::ENVMAP_LATLONG);
        else
            header.insert(name, Imf::StringAttribute(text));
    }
    return header;
}

Imf::Header makeHeader(const Image& image, const WriteOptions& options) { return makeHeader(image.width, image.height, image, options); }

/// Channels of interleaved samples that begin at row `firstRow` of the picture. @param rows  that there are
Imf::FrameBuffer frameBuffer(const Image& image, Imf::PixelType type, const void* samples, int firstRow, int rows)
{
    Imf::FrameBuffer buffer;
    const size_t sample = type == Imf::HALF ? sizeof(half) : sizeof(float);
    const size_t texel = sample * static_cast<size_t>(image.channels);
    size_t offset = 0;
    for (const std::string& name : channelNames(image.channels)) {
        const char* first = static_cast<const char*>(samples) + offset;
        buffer.insert(name,
                      Imf::Slice::Make(type, first, V2i(0, firstRow), image.width, rows, texel, texel * static_cast<size_t>(image.width)));
        offset += sample;
    }
    return buffer;
}

/// Half samples of whole rows, clamped to the largest half so that none becomes infinite.
std::vector<half> halfRows(const Image& image, int firstRow, int rows)
{
    constexpr float largest = 65504.0f;
    const size_t count = static_cast<size_t>(rows) * static_cast<size_t>(image.width) * static_cast<size_t>(image.channels);
    std::vector<half> samples(count);
    const float* values = image.row(firstRow);
    for (size_t i = 0; i < count; ++i)
        samples[i] = std::clamp(values[i], -largest, largest);
    return samples;
}

/// Runs what writes through OpenEXR; its own errors become ours, those of the file pass.
void writing(const std::function<void()>& body)
{
    try {
        startThreads();
        body();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw WorkError("OpenEXR cannot write the image: " + oneLine(error.what()) + "; check the attributes and the disk");
    }
}

} // namespace

void write(AtomicFile& file, const Image& image, const WriteOptions& options)
{
    writing([&] {
        OutputStream stream(file);
        Imf::OutputFile output(stream, makeHeader(image, options));
        if (options.sampleType == SampleType::Float) {
            output.setFrameBuffer(frameBuffer(image, Imf::FLOAT, image.texels.data(), 0, image.height));
            output.writePixels(image.height);
            return;
        }
        constexpr int blockRows = 256; // bounds the memory of the copy and still keeps all threads busy
        for (int y = 0; y < image.height; y += blockRows) {
            const int rows = std::min(blockRows, image.height - y);
            const std::vector<half> samples = halfRows(image, y, rows);
            output.setFrameBuffer(frameBuffer(image, Imf::HALF, samples.data(), y, rows));
            output.writePixels(rows);
        }
    });
}

void writeRows(AtomicFile& file, const PictureRows& picture, const WriteOptions& options)
{
    writing([&] {
        OutputStream stream(file);
        Imf::OutputFile output(stream, makeHeader(picture.width, picture.height, picture.sample, options));
        const bool isHalf = options.sampleType == SampleType::Half;
        for (int y = 0; y < picture.height; y += picture.atATime) {
            const int rows = std::min(picture.atATime, picture.height - y);
            const Image part = picture.rows(y, rows);
            const std::vector<half> samples = isHalf ? halfRows(part, 0, rows) : std::vector<half>();
            output.setFrameBuffer(isHalf ? frameBuffer(part, Imf::HALF, samples.data(), y, rows)
                                         : frameBuffer(part, Imf::FLOAT, part.texels.data(), y, rows));
            output.writePixels(rows);
        }
    });
}

void writePasses(AtomicFile& file, const std::vector<ImagePassData>& passes, const WriteOptions& options)
{
    writing([&] {
        OutputStream stream(file);
        const Image& first = passes.front().image;
        Imf::Header header = makeHeader(first, options);
        header.channels() = Imf::ChannelList();
        header.compression() = Imf::ZIP_COMPRESSION;
        const bool isHalf = options.sampleType == SampleType::Half;
        std::vector<std::vector<half>> samples; // kept until they are written
        Imf::FrameBuffer buffer;
        for (const ImagePassData& pass : passes) {
            if (isHalf)
                samples.push_back(halfRows(pass.image, 0, pass.image.height));
            const size_t sample = isHalf ? sizeof(half) : sizeof(float), texel = 3 * sample;
            const auto* texels =
                isHalf ? reinterpret_cast<const char*>(samples.back().data()) : reinterpret_cast<const char*>(pass.image.texels.data());
            for (const char channel : {'R', 'G', 'B'}) {
                const std::string name = pass.name + "." + channel;
                header.channels().insert(name, Imf::Channel(isHalf ? Imf::HALF : Imf::FLOAT));
                buffer.insert(name, Imf::Slice::Make(isHalf ? Imf::HALF : Imf::FLOAT, texels, V2i(0, 0), first.width, first.height, texel,
                                                     texel * static_cast<size_t>(first.width)));
                texels += sample;
            }
        }
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(buffer);
        output.writePixels(first.height);
    });
}

void writeMips(AtomicFile& file, const std::vector<Image>& levels, const WriteOptions& options)
{
    writing([&] {
        OutputStream stream(file);
        Imf::Header header = makeHeader(levels.front(), options);
        header.setTileDescription(Imf::TileDescription(tileEdge, tileEdge, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN));
        Imf::TiledOutputFile output(stream, header);
        for (int level = 0; level < output.numLevels(); ++level) {
            const Image& image = levels.at(static_cast<size_t>(level));
            const std::vector<half> samples =
                options.sampleType == SampleType::Half ? halfRows(image, 0, image.height) : std::vector<half>();
            output.setFrameBuffer(samples.empty() ? frameBuffer(image, Imf::FLOAT, image.texels.data(), 0, image.height)
                                                  : frameBuffer(image, Imf::HALF, samples.data(), 0, image.height));
            output.writeTiles(0, output.numXTiles(level) - 1, 0, output.numYTiles(level) - 1, level);
        }
    });
}

} // namespace mirrorball::exr
