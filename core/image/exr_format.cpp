#include "exr_format.h"

#include "exr_channels.h"
#include "exr_rows.h"
#include "exr_stream.h"
#include "exr_threads.h"
#include "input_checks.h"

#include "core/base/error.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfEnvmap.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <sstream>

namespace mirrorball::exr {
namespace {

using Imath::Box2i;
using Imath::V2i;

constexpr long long largestTile = 4096LL * 4096LL; ///< texels; OpenEXR allocates whole tiles, also for an image of one texel
/// Bytes of what is compressed as one, several of which OpenEXR holds at a time, however few rows the picture has: 256 rows of 4096 texels
/// of RGBA in half. Larger files may have larger ones.
constexpr std::uint64_t largestBlock = std::uint64_t{8} << 20;
constexpr std::uint64_t blockBytesPerByte = 64;
constexpr long long texelsPerByte = 256; ///< deflate ends at 172 of RGB in half

struct CompressionKind {
    const char* name;
    std::uint64_t largestRatio; ///< uncompressed : compressed, on the safe side: deflate ends at 1032, a DCT of zeros far later
    std::uint64_t rows;         ///< compressed as one
};

// clang-format off
constexpr std::array<CompressionKind, Imf::NUM_COMPRESSION_METHODS> compressionKinds{{
    {"none", 1, 1}, {"rle", 70, 1}, {"zips", 1100, 1}, {"zip", 1100, 16}, {"piz", 5000, 32}, {"pxr24", 2200, 16}, {"b44", 12, 32},
    {"b44a", 12, 32}, {"dwaa", 140000, 32}, {"dwab", 140000, 256},
}};
// clang-format on

FileError damaged(const std::filesystem::path& path, const std::exception& error)
{
    return FileError(path.string(), "the OpenEXR file is damaged (" + oneLine(error.what()) + "); export or download it again");
}

long long bytesPerTexel(const Imf::ChannelList& channels)
{
    long long bytes = 0;
    for (auto i = channels.begin(); i != channels.end(); ++i)
        bytes += i.channel().type == Imf::HALF ? 2 : 4;
    return bytes;
}

/// Refuses, before anything is allocated for them, sizes that no file of this length can hold.
void checkPlausible(const OpenedFile& file, const Imf::Header& header)
{
    const std::string path = file.path().string();
    const Box2i window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    checkImageSize(path, width, height, maxStreamedTexels);
    const std::uint64_t fileBytes = file.size();
    const CompressionKind& compression = compressionKinds[header.compression()];
    const auto texelBytes = static_cast<std::uint64_t>(bytesPerTexel(header.channels()));
    // Subsampled channels count in full below; a factor of 4 pays for them.
    const auto bytes = static_cast<std::uint64_t>(width * height) * texelBytes / 4;
    if (bytes / compression.largestRatio > fileBytes)
        throw FileError(path, "the file is too short for " + std::to_string(width) + " x " + std::to_string(height) +
                                  " texels; export or download it again");
    checkTexelsHeld(path, width, height, fileBytes, texelsPerByte);
    const std::uint64_t mostInBlock = std::max(largestBlock, blockBytesPerByte * fileBytes);
    if (!header.hasTileDescription()) {
        if (static_cast<std::uint64_t>(width) * compression.rows * texelBytes > mostInBlock)
            throw FileError(path, "its rows of " + std::to_string(width) + " texels are far wider than a file of " +
                                      std::to_string(fileBytes) + " bytes can tell of; it is damaged or blank, export it again");
        return;
    }
    const auto tileTexels = static_cast<long long>(header.tileDescription().xSize) * static_cast<long long>(header.tileDescription().ySize);
    if (tileTexels > std::max(largestTile, 4 * width * height))
        throw FileError(path, "its tiles are larger than 4096 x 4096 texels; export it with smaller ones");
}

/// The matrix for colors of other primaries. @throws FileError for primaries that make no sense
std::optional<glm::mat3> conversion(const std::string& path, const Imf::Header& header)
{
    if (!Imf::hasChromaticities(header))
        return std::nullopt;
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    const auto point = [](const Imath::V2f& xy) { return glm::dvec2(xy.x, xy.y); };
    return conversionFrom(path, {point(c.red), point(c.green), point(c.blue), point(c.white)});
}

/// Subsampled colors are read from RY and BY only.
void checkSampling(const std::string& path, const Imf::Header& header, const ColorChannels& channels)
{
    for (const std::string& name : channels.rgb) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (channel && (channel->xSampling != 1 || channel->ySampling != 1))
            throw FileError(path,
                            "its channel " + oneLine(name) + " is subsampled, which only RY and BY may be; export it in full resolution");
    }
}

/// Where a level's data lies in the picture that is read.
struct Placement {
    int width = 0, height = 0; ///< of the picture
    int left = 0, top = 0;     ///< of the data in it, also negative
    int dataWidth = 0, dataHeight = 0;

    bool isWhole() const { return left == 0 && top == 0 && dataWidth == width && dataHeight == height; }
    /// Texels of the picture that the data covers.
    std::int64_t covered() const
    {
        const auto overlap = [](int at, int size, int all) { return std::max(0, std::min(at + size, all) - std::max(at, 0)); };
        return std::int64_t{overlap(left, dataWidth, width)} * overlap(top, dataHeight, height);
    }
};

std::string sizeText(long long width, long long height) { return std::to_string(width) + " x " + std::to_string(height); }

/// @param data  window of the level. @throws FileError where the display window is absurd, or shows nothing of the data
Placement placement(const OpenedFile& file, const Imf::Header& header, const Box2i& data, int level, PictureWindow window)
{
    Placement place{.dataWidth = data.max.x - data.min.x + 1, .dataHeight = data.max.y - data.min.y + 1};
    place.width = place.dataWidth;
    place.height = place.dataHeight;
    const Box2i& display = header.displayWindow();
    if (window == PictureWindow::Data || display == header.dataWindow())
        return place;
    const long long width = (static_cast<long long>(display.max.x) - display.min.x + 1) >> level;
    const long long height = (static_cast<long long>(display.max.y) - display.min.y + 1) >> level;
    checkImageSize(file.path().string(), std::max(width, 1LL), std::max(height, 1LL));
    // Black texels cost memory, too: a file of this length cannot ask for much more than it holds.
    const auto most = std::max<std::uint64_t>(std::uint64_t{1} << 24, 256 * file.size());
    const Box2i all = header.dataWindow();
    const long long dx = static_cast<long long>(all.min.x) - display.min.x, dy = static_cast<long long>(all.min.y) - display.min.y;
    const bool apart = dx + place.dataWidth <= 0 || dy + place.dataHeight <= 0 || dx >> level >= width || dy >> level >= height;
    if (apart || static_cast<std::uint64_t>(width * height) > most)
        throw FileError(file.path().string(), "its display window of " + sizeText(width, height) + " texels " +
                                                  (apart ? "shows nothing of its data" : "is far larger than its data") + " of " +
                                                  sizeText(place.dataWidth, place.dataHeight) + "; read it with --window data");
    place.width = static_cast<int>(width);
    place.height = static_cast<int>(height);
    place.left = static_cast<int>(dx >> level);
    place.top = static_cast<int>(dy >> level);
    return place;
}

class ExrReader final : public ImageReader {
public:
    ExrReader(OpenedFile file, Channels channels)
        : m_stream(std::move(file)), m_file(m_stream, Imf::globalThreadCount(), false), m_channels(channels),
          m_floats(texelFloats(channels))
    {
    }

    const Imf::MultiPartInputFile& file() const { return m_file; }

    /// Makes one level of a picture what is read.
    void show(ChosenPicture chosen, int level, const ProbeReading& reading)
    {
        const std::filesystem::path& path = m_stream.file().path();
        const Imf::Header& header = m_file.header(chosen.picture.part);
        checkPlausible(m_stream.file(), header);
        checkSampling(path.string(), header, chosen.picture.channels);
        if (reading.colorSpace.empty())
            m_toRec709 = conversion(path.string(), header);
        OpenedRows opened = openRows(m_stream, m_file, chosen.picture, m_channels, level);
        if (!opened.rows)
            throw FileError(path.string(), "there is no mip level " + std::to_string(level) + " among its " +
                                               std::to_string(opened.levels) + "; ask for one it has");
        m_rows = std::move(opened.rows);
        m_place = placement(m_stream.file(), header, m_rows->window(), level, reading.window);
        m_info.levels = opened.levels;
        m_info.assumed = std::move(chosen.assumed);
        describe(path, header, chosen.picture.channels);
        describeWindows(header, reading.window);
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        try {
            if (m_place.isWhole())
                m_rows->read(firstRow, rows, texels);
            else
                readPlaced(firstRow, rows, texels);
        } catch (const std::exception& error) {
            throw damaged(m_info.path, error);
        }
        if (!m_toRec709)
            return;
        const size_t count = static_cast<size_t>(m_info.width) * static_cast<size_t>(rows);
        for (size_t i = 0; i < count; ++i, texels += m_floats) {
            const glm::vec3 color = *m_toRec709 * glm::vec3(texels[0], texels[1], texels[2]);
            std::copy_n(&color.x, 3, texels);
        }
    }

private:
    void readPlaced(int firstRow, int rows, float* texels)
    {
        const auto floats = static_cast<size_t>(m_floats);
        const size_t rowFloats = floats * static_cast<size_t>(m_place.width);
        std::fill_n(texels, rowFloats * static_cast<size_t>(rows), 0.0f);
        const int first = std::max(firstRow, m_place.top), last = std::min(firstRow + rows, m_place.top + m_place.dataHeight);
        const int from = std::max(0, m_place.left), to = std::min(m_place.width, m_place.left + m_place.dataWidth);
        if (first >= last || from >= to)
            return;
        m_placed.resize(floats * static_cast<size_t>(m_place.dataWidth) * static_cast<size_t>(last - first));
        m_rows->read(first - m_place.top, last - first, m_placed.data());
        for (int y = first; y < last; ++y) {
            const size_t dataRow = static_cast<size_t>(y - first) * static_cast<size_t>(m_place.dataWidth);
            std::copy_n(m_placed.data() + floats * (dataRow + static_cast<size_t>(from - m_place.left)),
                        floats * static_cast<size_t>(to - from),
                        texels + rowFloats * static_cast<size_t>(y - firstRow) + floats * static_cast<size_t>(from));
        }
    }

    void describe(const std::filesystem::path& path, const Imf::Header& header, const ColorChannels& channels)
    {
        static constexpr std::array<const char*, 3> sampleTypes{"uint", "half", "float"};
        m_info.path = path;
        m_info.format = "openexr";
        m_info.width = m_place.width;
        m_info.height = m_place.height;
        m_info.offsetX = header.dataWindow().min.x - header.displayWindow().min.x;
        m_info.offsetY = header.dataWindow().min.y - header.displayWindow().min.y;
        for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
            ++m_info.channels;
        const std::string named = channels.rgb[0].empty() ? channels.rgb[1] : channels.rgb[0];
        m_info.sampleType = sampleTypes.at(header.channels().findChannel(named)->type);
        m_info.tiled = header.hasTileDescription();
        m_info.parts = m_file.parts();
        m_info.compression = compressionKinds[header.compression()].name;
        if (Imf::hasEnvmap(header))
            m_info.envmap = Imf::envmap(header) == Imf::ENVMAP_CUBE ? "cube" : "latlong";
        for (auto i = header.begin(); i != header.end(); ++i)
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
                text && std::string_view(i.name()).starts_with("mirrorball:"))
                m_info.attributes[i.name()] = text->value();
        assume(m_info.assumed,
               {"encoding", m_toRec709 ? "linear, brought to Rec.709 from the file's primaries" : "linear, Rec.709 primaries",
                Imf::hasChromaticities(header) ? "OpenEXR's chromaticities" : "OpenEXR without chromaticities"});
        assume(m_info.assumed, {"alpha", channels.alpha.empty() ? "none" : "colors are multiplied by it", "OpenEXR's convention"});
        assume(m_info.assumed, {"orientation", "upright", "OpenEXR has no other"});
    }

    void describeWindows(const Imf::Header& header, PictureWindow window)
    {
        const std::string data = "data " + sizeText(m_place.dataWidth, m_place.dataHeight);
        Assumption windows{"windows", m_place.isWhole() ? data : "display " + sizeText(m_place.width, m_place.height),
                           window == PictureWindow::Data                   ? "asked for"
                           : header.displayWindow() == header.dataWindow() ? "both windows agree"
                                                                           : "OpenEXR's display window is the picture"};
        if (!m_place.isWhole()) {
            windows.others.push_back(data + " at " + std::to_string(m_place.left) + ", " + std::to_string(m_place.top));
            const std::int64_t all = std::int64_t{m_place.width} * m_place.height;
            const std::int64_t cut = std::int64_t{m_place.dataWidth} * m_place.dataHeight - m_place.covered();
            m_info.blackTexels = all - m_place.covered();
            if (m_info.blackTexels > 0)
                m_info.notes.push_back(std::to_string(m_info.blackTexels) + " of " + std::to_string(all) +
                                       " texels lie outside its data window and are black");
            if (cut > 0)
                m_info.notes.push_back(std::to_string(cut) + " texels of overscan lie outside its display window and are cut off");
        }
        assume(m_info.assumed, std::move(windows));
        if (const float aspect = header.pixelAspectRatio(); aspect != 1.0f) {
            std::ostringstream note;
            note << "its pixel aspect ratio is " << aspect
                 << ", which is not applied: texels count as what the shape of the picture makes them";
            m_info.notes.push_back(note.str());
        }
    }

    FileStream m_stream;
    Imf::MultiPartInputFile m_file; ///< reads the stream
    Channels m_channels;
    int m_floats;
    Placement m_place{};
    ImageFileInfo m_info{};
    std::optional<glm::mat3> m_toRec709{};
    std::unique_ptr<RowSource> m_rows{};
    std::vector<float> m_placed{};
};

/// What OpenEXR says of a file in words that name it.
template <typename Open>
std::unique_ptr<ExrReader> readOf(const std::filesystem::path& path, const Open& open)
{
    startThreads();
    try {
        return open();
    } catch (const FileError&) {
        throw;
    } catch (const std::exception& error) {
        throw damaged(path, error);
    }
}

} // namespace

void startThreads()
{
    static const bool started = [] {
        if (Imf::globalThreadCount() == 0)
            Imf::setGlobalThreadCount(JobControl{}.threadCount());
        return true;
    }();
    static_cast<void>(started);
}

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with("\x76\x2f\x31\x01"); }

std::unique_ptr<ImageReader> open(OpenedFile file, int level, const ProbeReading& reading, Channels channels)
{
    const std::filesystem::path path = file.path();
    return readOf(path, [&] {
        auto reader = std::make_unique<ExrReader>(std::move(file), channels);
        reader->show(choosePicture(path.string(), reader->file(), reading), level, reading);
        return reader;
    });
}

std::unique_ptr<ImageReader> openPass(OpenedFile file, const std::string& pass, Channels channels)
{
    const std::filesystem::path path = file.path();
    return readOf(path, [&]() -> std::unique_ptr<ExrReader> {
        auto reader = std::make_unique<ExrReader>(std::move(file), channels);
        const std::optional<Picture> found = findPass(reader->file(), pass);
        if (!found)
            return nullptr;
        reader->show({*found}, 0, {});
        return reader;
    });
}

} // namespace mirrorball::exr
