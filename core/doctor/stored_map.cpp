#include "stored_map.h"

#include "core/base/error.h"
#include "core/image/container/container_file.h"
#include "core/image/container/play_canvas_atlas.h"
#include "core/image/container/png_codec.h"
#include "core/image/image_io.h"
#include "core/image/layout_detection.h"
#include "core/image/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 6> faceWords{"px", "nx", "py", "ny", "pz", "nz"};
constexpr int mostLevels = 32;

StoredLevel repaired(Image image)
{
    StoredLevel level{std::move(image), {}};
    level.repaired = repair(level.image, NegativePolicy::Keep);
    return level;
}

std::string replaced(std::string name, std::string_view mark, std::string_view word)
{
    const size_t at = name.find(mark);
    return at == std::string::npos ? name : name.replace(at, mark.size(), word);
}

Image readWhole(ImageReader& reader)
{
    Image image(reader.info().width, reader.info().height, 3);
    reader.readRows(0, image.height, image.texels.data());
    return image;
}

struct Picture {
    ImageFileInfo info{};
    Image image{};
};

/// A .png picture whose alpha multiplies its colors, as radiance.
Picture packedPicture(const std::filesystem::path& path, PackedColor form)
{
    constexpr std::uint64_t largestFile = std::uint64_t{1} << 28; // the texels that are read below, and then some
    const std::string bytes = OpenedFile(path).readAll(largestFile);
    if (!bytes.starts_with("\x89PNG"))
        throw FileError(path.string(),
                        "is no .png picture, in which alone texels are packed as " + std::string(wordOf(form)) + "; leave out --encode");
    constexpr long long largest = 1LL << 26;
    const png::Picture png = png::decode(bytes, path.string(), largest);
    Picture picture{{}, Image(png.width, png.height, 3)};
    picture.info.format = "png";
    picture.info.sampleType = wordOf(form);
    picture.info.width = png.width;
    picture.info.height = png.height;
    picture.info.levels = 1;
    for (size_t i = 0; i < png.texels.size(); ++i) {
        const glm::vec3 rgb = unpackColor(form, png.texels[i]);
        std::copy_n(&rgb.x, 3, picture.image.texels.data() + 3 * i);
    }
    return picture;
}

Picture pictureOf(const std::filesystem::path& path, const StoredMapReading& reading)
{
    if (reading.packed)
        return packedPicture(path, *reading.packed);
    const std::unique_ptr<ImageReader> reader = openImage(path);
    return {reader->info(), readWhole(*reader)};
}

/// A rectangle of an atlas as a latlong: its inner texels, which run around and end at the poles, at the centers of one that is twice as
/// wide as high; by Keys' cubic, held within the range of the four nearest.
Image latlongOf(const Image& atlas, const play_canvas_atlas::Rectangle& r)
{
    const int width = r.width - 2, height = r.height - 2; // without the border
    Image latlong(2 * r.height, r.height, 3);
    const auto texel = [&](int i, int j) {
        return atlas.texel(r.x + 1 + (i % width + width) % width, r.y + 1 + std::clamp(j, 0, height - 1));
    };
    for (int y = 0; y < latlong.height; ++y)
        for (int x = 0; x < latlong.width; ++x) {
            const double u = (x + 0.5) / latlong.width * width - 0.5, v = (y + 0.5) / latlong.height * height - 0.5;
            const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
            const auto across = keysWeights(u - i), down = keysWeights(v - j);
            for (int c = 0; c < 3; ++c) {
                float sum = 0.0f;
                for (int dj = 0; dj < 4; ++dj)
                    for (int di = 0; di < 4; ++di)
                        sum += across[static_cast<size_t>(di)] * down[static_cast<size_t>(dj)] * texel(i + di - 1, j + dj - 1)[c];
                const auto [least, most] = std::minmax({texel(i, j)[c], texel(i + 1, j)[c], texel(i, j + 1)[c], texel(i + 1, j + 1)[c]});
                latlong.texel(x, y)[c] = std::clamp(sum, least, most);
            }
        }
    return latlong;
}

/// The environment, the levels that the shader reads at roughness 0.2 to 1, and the diffuse light.
StoredMap ofAtlas(const Image& atlas, PackedColor form)
{
    StoredMap map;
    map.container = "playcanvas atlas";
    map.texels = wordOf(form);
    map.shape = "one .png of 512 x 512 packed texels, as PlayCanvas' envAtlas lays its latlongs out";
    map.kind = Parameterization::Latlong;
    const auto add = [&](auto isWanted) {
        for (const play_canvas_atlas::Rectangle& r : play_canvas_atlas::rectangles)
            if (isWanted(r))
                map.levels.push_back(repaired(latlongOf(atlas, r)));
    };
    using play_canvas_atlas::Content;
    add([](const auto& r) { return r.content == Content::Source && r.level == 0; });
    add([](const auto& r) { return r.content == Content::Specular && r.level <= 5; });
    add([](const auto& r) { return r.content == Content::Diffuse; });
    return map;
}

/// One picture as a level of the map. What OpenEXR's attribute says about edges and mirrored faces is left for the measurement to find.
std::optional<Image> asLevel(Image image, ImageFileInfo info, std::optional<Parameterization> kind, Detection& found)
{
    info.width = image.width;
    info.height = image.height;
    info.envmap.clear();
    if (kind && *kind != Parameterization::Cube && image.width == 1 && image.height == 1 && info.levels > 1)
        return std::nullopt; // what a format's own chain ends in is no level of a 2 N x N map
    try {
        found = detectLayout(info, kind);
    } catch (const FileError&) {
        if (!kind) // the first picture must fit something; levels that no longer fit end the chain
            throw;
        return std::nullopt;
    }
    return toEnvironmentMap(std::move(image), found).image;
}

StoredMap ofContainer(const std::filesystem::path& path)
{
    ContainedTexture contained = readContainer(path);
    StoredMap map;
    map.container = contained.format;
    map.texels = contained.texels;
    map.metadata = contained.texture.metadata;
    if (contained.texture.slices > 1)
        throw FileError(path.string(), "is an array of pictures; give a cube, or one picture");
    map.shape = contained.texture.faces == 6 ? "the container holds a cube" : "the container holds one picture";
    if (contained.texture.faces != 6) {
        const int width = contained.texture.width(), height = contained.texture.height();
        if (width != 2 * height)
            throw FileError(path.string(), "holds one picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                               " texels, which is neither a cube nor a latlong");
        map.kind = Parameterization::Latlong;
    }
    for (Image& level : contained.texture.levels)
        if (map.kind == Parameterization::Cube || level.width == 2 * level.height)
            map.levels.push_back(repaired(std::move(level)));
    return map;
}

/// One image file, or one file a level.
StoredMap ofImages(const std::vector<std::filesystem::path>& paths, const StoredMapReading& reading, const JobControl& job)
{
    StoredMap map;
    map.files = paths.size();
    for (const std::filesystem::path& path : paths) {
        Picture first = pictureOf(path, reading);
        const ImageFileInfo info = first.info;
        const int levels = paths.size() == 1 ? std::clamp(info.levels, 1, mostLevels) : 1;
        for (int l = 0; l < levels; ++l) {
            job.checkStop();
            const bool begins = map.levels.empty();
            Detection found;
            std::optional<Image> image =
                asLevel(l == 0 ? std::move(first.image) : readLevel(path, l), info, begins ? reading.from : std::optional(map.kind), found);
            if (!image)
                return map;
            if (begins) {
                map.container = info.format + (paths.size() > 1 ? " levels" : "");
                map.texels = info.sampleType;
                map.kind = found.layout.kind;
                map.shape = found.reason;
                map.certain = found.certain;
            }
            map.levels.push_back(repaired(std::move(*image)));
        }
    }
    return map;
}

/// Six square pictures a level.
StoredMap ofFaces(const std::vector<std::string>& names, const StoredMapReading& reading, const JobControl& job)
{
    StoredMap map;
    map.shape = "six faces by name";
    map.files = 6 * names.size();
    for (const std::string& name : names) {
        Image level;
        for (size_t face = 0; face < 6; ++face) {
            job.checkStop();
            const std::filesystem::path path = replaced(name, "%s", faceWords[face]);
            const auto [info, picture] = pictureOf(path, reading);
            if (level.empty()) {
                map.container = info.format + " faces";
                map.texels = info.sampleType;
                level = Image(picture.width, 6 * picture.width, 3);
            }
            if (picture.width != level.width || picture.height != level.width)
                throw FileError(path.string(), "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                                                   " texels where a face of " + std::to_string(level.width) + " x " +
                                                   std::to_string(level.width) + " is needed");
            std::copy(picture.texels.begin(), picture.texels.end(), level.row(static_cast<int>(face) * level.width));
        }
        map.levels.push_back(repaired(std::move(level)));
    }
    return map;
}

/// The names of the levels that are there, `%s` still in them.
std::vector<std::string> levelNames(const std::string& path)
{
    if (path.find("%d") == std::string::npos)
        return {path};
    const auto there = [&](int level) {
        return std::filesystem::exists(replaced(replaced(path, "%d", std::to_string(level)), "%s", faceWords[0]));
    };
    std::vector<std::string> names;
    for (int level = there(0) ? 0 : 1; level < mostLevels && there(level); ++level)
        names.push_back(replaced(path, "%d", std::to_string(level)));
    if (names.empty())
        throw FileError(path, "no such files: neither level 0 nor level 1 is there");
    return names;
}

} // namespace

StoredMap readStoredMap(const std::string& path, const StoredMapReading& reading, const JobControl& job)
{
    StoredMap map;
    const bool isAtlasForm = reading.packed == PackedColor::Rgbp || reading.packed == PackedColor::Rgbm;
    if (!std::filesystem::exists(path)) {
        const std::vector<std::string> names = levelNames(path);
        map = path.find("%s") != std::string::npos ? ofFaces(names, reading, job) : ofImages({names.begin(), names.end()}, reading, job);
    } else if (isContainer(OpenedFile(path).firstBytes())) {
        if (reading.packed)
            throw FileError(path, "is a container, which says itself how its texels are packed; leave out --encode");
        map = ofContainer(path);
    } else if (const Picture picture = isAtlasForm && !reading.from ? packedPicture(path, *reading.packed) : Picture{};
               picture.image.width == play_canvas_atlas::size && picture.image.height == play_canvas_atlas::size) {
        map = ofAtlas(picture.image, *reading.packed);
    } else {
        map = ofImages({path}, reading, job);
    }
    if (map.levels.empty())
        throw FileError(path, "holds no levels");
    return map;
}

} // namespace mirrorball
