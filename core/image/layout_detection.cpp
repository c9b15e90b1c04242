#include "layout_detection.h"

#include "core/base/error.h"
#include "core/sphere/cube_map.h"
#include "reproject.h"

#include <array>
#include <charconv>
#include <cstdlib>

namespace mirrorball {

namespace {

std::string sizeText(const ImageFileInfo& info) { return std::to_string(info.width) + " x " + std::to_string(info.height); }

/// The cube arrangement of this shape, and the edge of its faces.
struct CubeShape {
    Arrangement arrangement;
    int faceSize;
    const char* description;
};

std::optional<CubeShape> cubeShape(int width, int height)
{
    struct Known {
        int columns, rows;
        Arrangement arrangement;
        const char* description;
    };
    constexpr std::array<Known, 6> known{{{1, 6, Arrangement::Whole, "1:6, six cube faces stacked"},
                                          {6, 1, Arrangement::HorizontalStrip, "6:1, six cube faces in a row"},
                                          {3, 2, Arrangement::Grid3x2, "3:2, cube faces in two rows"},
                                          {2, 3, Arrangement::Grid2x3, "2:3, cube faces in three rows"},
                                          {4, 3, Arrangement::HorizontalCross, "4:3, a horizontal cross"},
                                          {3, 4, Arrangement::VerticalCross, "3:4, a vertical cross"}}};
    for (const Known& k : known)
        if (width % k.columns == 0 && height % k.rows == 0 && width / k.columns == height / k.rows)
            return CubeShape{k.arrangement, width / k.columns, k.description};
    return {};
}

/// The sizes that a kind comes in, for messages.
std::string sizesOf(Parameterization kind)
{
    switch (kind) {
    case Parameterization::Latlong:
        return "2N x N";
    case Parameterization::Cube:
        return "N x 6N, 6N x N, 3N x 2N, 2N x 3N, a cross of 4N x 3N or one of 3N x 4N";
    case Parameterization::Paraboloid:
        return "2N x N, the two halves side by side";
    default:
        return "N x N";
    }
}

/// An image of this size as a map of this kind, if it can be one.
std::optional<Detection> asKind(const ImageFileInfo& info, Parameterization kind, int border)
{
    if (info.width == 1 && info.height == 1)
        return Detection{{kind, 1, 0}, Arrangement::Constant, {}, true};
    if (kind == Parameterization::Cube) {
        const auto shape = cubeShape(info.width, info.height);
        if (!shape)
            return {};
        return Detection{{kind, shape->faceSize, 0}, shape->arrangement, shape->description, true};
    }
    const MapLayout layout{kind, info.height, border};
    if (layout.width() != info.width || border < 0 || (border > 0 && 2 * border >= info.height))
        return {};
    return Detection{layout, Arrangement::Whole, {}, true};
}

int borderAttribute(const ImageFileInfo& info)
{
    const auto found = info.attributes.find("mirrorball:border");
    int border = 0;
    if (found != info.attributes.end())
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), border);
    return border;
}

std::optional<Detection> fromEnvmapAttribute(const ImageFileInfo& info)
{
    if (info.envmap == "latlong" && info.width >= 2 && info.height >= 2)
        return Detection{{Parameterization::Latlong, info.height, 0}, Arrangement::EdgeSampledLatlong, "OpenEXR envmap latlong", true};
    if (info.envmap == "cube" && info.width >= 2 && info.height == 6 * info.width)
        return Detection{{Parameterization::Cube, info.width, 0}, Arrangement::OpenExrCube, "OpenEXR envmap cube", true};
    return {};
}

std::optional<Detection> fromOwnAttributes(const ImageFileInfo& info)
{
    const auto found = info.attributes.find("mirrorball:parameterization");
    if (found == info.attributes.end())
        return {};
    const auto kind = parameterizationFromName(found->second);
    if (!kind)
        return {};
    auto detection = asKind(info, *kind, *kind == Parameterization::Paraboloid ? borderAttribute(info) : 0);
    if (detection)
        detection->reason = "the file says " + found->second;
    return detection;
}

/// Where a face lies in a sheet and how it is turned: its cell, and the directions of image right, image down and the face itself.
struct Cell {
    int column, row;
    glm::ivec3 right, down, forward;
};

/// Pictures from inside: walking to the right from the front, +Z, one meets -X, then -Z, then +X, as in the latlong.
constexpr glm::ivec3 posX{1, 0, 0}, negX{-1, 0, 0}, posY{0, 1, 0}, negY{0, -1, 0}, posZ{0, 0, 1}, negZ{0, 0, -1};
constexpr std::array<Cell, 6> horizontalCross{{{1, 0, negX, posZ, posY},   // top; its lower edge meets the front
                                               {0, 1, posZ, negY, posX},   // left
                                               {1, 1, negX, negY, posZ},   // front
                                               {2, 1, negZ, negY, negX},   // right
                                               {3, 1, posX, negY, negZ},   // back
                                               {1, 2, negX, negZ, negY}}}; // bottom; its upper edge meets the front
constexpr std::array<Cell, 6> verticalCross{{{1, 0, negX, posZ, posY},
                                             {0, 1, posZ, negY, posX},
                                             {1, 1, negX, negY, posZ},
                                             {2, 1, negZ, negY, negX},
                                             {1, 2, negX, negZ, negY},
                                             {1, 3, negX, posY, negZ}}}; // back, below the bottom and turned with it

/// Six faces with OpenGL's axes in reading order, `columns` to a row.
std::array<Cell, 6> grid(int columns)
{
    std::array<Cell, 6> cells{};
    for (int face = 0; face < 6; ++face) {
        const glm::dvec3 m = cube_map::facePoint(face, 0, 0);
        cells[static_cast<size_t>(face)] = {face % columns, face / columns, glm::ivec3(cube_map::facePoint(face, 1, 0) - m),
                                            glm::ivec3(cube_map::facePoint(face, 0, 1) - m), glm::ivec3(m)};
    }
    return cells;
}

/// Every texel of the cube from its cell: whole numbers only, so texels are moved, never mixed.
EnvironmentMap cutUp(const Image& image, const std::array<Cell, 6>& cells, int n)
{
    EnvironmentMap map({Parameterization::Cube, n, 0});
    const auto dot = [](const glm::ivec3& a, const glm::ivec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const std::array<Cell, 6> faces = grid(1);
    for (const Cell& face : faces)
        for (const Cell& cell : cells) {
            if (cell.forward != face.forward)
                continue;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const glm::ivec3 point = (2 * x + 1 - n) * face.right + (2 * y + 1 - n) * face.down;
                    const int sheetX = cell.column * n + (dot(point, cell.right) + n - 1) / 2;
                    const int sheetY = cell.row * n + (dot(point, cell.down) + n - 1) / 2;
                    std::copy_n(image.texel(sheetX, sheetY), 3, map.image.texel(x, face.row * n + y));
                }
        }
    return map;
}

} // namespace

Detection detectLayout(const ImageFileInfo& info, std::optional<Parameterization> forced)
{
    if (info.width < 1 || info.height < 1)
        throw FileError(info.path.string(), "an image of " + sizeText(info) + " texels holds no map");
    const auto fromFile = fromEnvmapAttribute(info);
    if (forced) {
        if (fromFile && fromFile->layout.kind == *forced)
            return *fromFile;
        const auto own = fromOwnAttributes(info);
        auto detection = own && own->layout.kind == *forced ? own : asKind(info, *forced, 0);
        if (!detection)
            throw FileError(info.path.string(), "an image of " + sizeText(info) + " texels is no " + std::string(name(*forced)) +
                                                    " map: that needs " + sizesOf(*forced));
        detection->reason = "read as " + std::string(name(*forced)) + " on request";
        return *detection;
    }
    if (fromFile)
        return *fromFile;
    if (const auto own = fromOwnAttributes(info))
        return *own;
    if (info.width == 1 && info.height == 1)
        return {{Parameterization::Latlong, 1, 0}, Arrangement::Constant, "a single texel, the same in every direction", true};
    if (info.width == 2 * info.height)
        return {{Parameterization::Latlong, info.height, 0}, Arrangement::Whole, "2:1, taken for a latlong", true};
    if (info.width == info.height)
        return {{Parameterization::Angular, info.width, 0},
                Arrangement::Whole,
                "a square, taken for an angular map; it may as well be sphere or octahedral",
                false};
    if (auto cube = asKind(info, Parameterization::Cube, 0))
        return *cube;
    throw FileError(info.path.string(),
                    "an image of " + sizeText(info) +
                        " texels fits no map: a latlong or paraboloid is 2N x N, a sphere, angular or octahedral map N x N, a cube " +
                        sizesOf(Parameterization::Cube));
}

EnvironmentMap toEnvironmentMap(Image image, const Detection& detection, const JobControl& job)
{
    const MapLayout& layout = detection.layout;
    const int n = layout.size;
    glm::ivec2 expected{layout.width(), layout.height()};
    switch (detection.arrangement) {
    case Arrangement::Whole:
        break;
    case Arrangement::Constant:
        expected = {1, 1};
        break;
    case Arrangement::EdgeSampledLatlong:
        return fromEdgeSampledLatlong(image, job);
    case Arrangement::OpenExrCube:
        return fromOpenExrCube(image, job);
    case Arrangement::HorizontalStrip:
        expected = {6 * n, n};
        break;
    case Arrangement::Grid3x2:
        expected = {3 * n, 2 * n};
        break;
    case Arrangement::Grid2x3:
        expected = {2 * n, 3 * n};
        break;
    case Arrangement::HorizontalCross:
        expected = {4 * n, 3 * n};
        break;
    case Arrangement::VerticalCross:
        expected = {3 * n, 4 * n};
        break;
    }
    if (image.width != expected.x || image.height != expected.y || image.channels != 3)
        throw InvalidArgument("the image has " + std::to_string(image.width) + " x " + std::to_string(image.height) + " texels of " +
                              std::to_string(image.channels) + " channels where its header promised " + std::to_string(expected.x) + " x " +
                              std::to_string(expected.y) + " of 3");
    switch (detection.arrangement) {
    case Arrangement::Constant: {
        EnvironmentMap map(layout);
        for (int y = 0; y < map.image.height; ++y)
            for (int x = 0; x < map.image.width; ++x)
                std::copy_n(image.texel(0, 0), 3, map.image.texel(x, y));
        return map;
    }
    case Arrangement::HorizontalStrip:
        return cutUp(image, grid(6), n);
    case Arrangement::Grid3x2:
        return cutUp(image, grid(3), n);
    case Arrangement::Grid2x3:
        return cutUp(image, grid(2), n);
    case Arrangement::HorizontalCross:
        return cutUp(image, horizontalCross, n);
    case Arrangement::VerticalCross:
        return cutUp(image, verticalCross, n);
    default:
        return {layout, std::move(image)};
    }
}

} // namespace mirrorball
