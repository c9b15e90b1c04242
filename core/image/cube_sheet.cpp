#include "cube_sheet.h"

#include "core/base/error.h"
#include "core/sphere/cube_map.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace mirrorball {

namespace {

/// Where a face lies in a sheet and how it is turned: its cell, and the directions of image right, image down and the face itself.
struct Cell {
    int column, row;
    glm::ivec3 right, down, forward;
};
using Cells = std::array<Cell, 6>;

/// Pictures from inside: walking to the right from the front, +Z, one meets -X, then -Z, then +X, as in the latlong.
constexpr glm::ivec3 posX{1, 0, 0}, negX{-1, 0, 0}, posY{0, 1, 0}, negY{0, -1, 0}, posZ{0, 0, 1}, negZ{0, 0, -1};
constexpr Cells horizontalCross{{{1, 0, negX, posZ, posY},   // top; its lower edge meets the front
                                 {0, 1, posZ, negY, posX},   // left
                                 {1, 1, negX, negY, posZ},   // front
                                 {2, 1, negZ, negY, negX},   // right
                                 {3, 1, posX, negY, negZ},   // back
                                 {1, 2, negX, negZ, negY}}}; // bottom; its upper edge meets the front
constexpr Cells verticalCross{{{1, 0, negX, posZ, posY},
                               {0, 1, posZ, negY, posX},
                               {1, 1, negX, negY, posZ},
                               {2, 1, negZ, negY, negX},
                               {1, 2, negX, negZ, negY},
                               {1, 3, negX, posY, negZ}}}; // back, below the bottom and turned with it

/// Six faces with OpenGL's axes in reading order, `columns` to a row.
Cells grid(int columns)
{
    Cells cells{};
    for (int face = 0; face < 6; ++face) {
        const glm::dvec3 m = cube_map::facePoint(face, 0, 0);
        cells[static_cast<size_t>(face)] = {face % columns, face / columns, glm::ivec3(cube_map::facePoint(face, 1, 0) - m),
                                            glm::ivec3(cube_map::facePoint(face, 0, 1) - m), glm::ivec3(m)};
    }
    return cells;
}

bool isCross(CubeSheet sheet) { return sheet == CubeSheet::HorizontalCross || sheet == CubeSheet::VerticalCross; }

Cells cells(CubeSheet sheet)
{
    if (isCross(sheet))
        return sheet == CubeSheet::HorizontalCross ? horizontalCross : verticalCross;
    return grid(cellsOf(sheet).x);
}

struct NamedFace {
    int face; ///< 0 to 5: +X -X +Y -Y +Z -Z
    int quarterTurns;
};

[[noreturn]] void refuse(const std::string& faces)
{
    throw InvalidArgument("faces: must be px nx py ny pz nz in the order of the file, each once, with :90, :180 or :270 where one lies "
                          "turned; it is '" +
                          faces + "'");
}

std::vector<NamedFace> parse(const std::string& faces)
{
    constexpr std::array<std::string_view, 6> names{"px", "nx", "py", "ny", "pz", "nz"};
    std::string text = faces;
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream stream(text);
    std::vector<NamedFace> found;
    std::array<bool, 6> used{};
    for (std::string word; stream >> word;) {
        const size_t colon = word.find(':');
        const auto name = std::find(names.begin(), names.end(), word.substr(0, colon));
        const std::string turn = colon == std::string::npos ? "0" : word.substr(colon + 1);
        const bool known = turn == "0" || turn == "90" || turn == "180" || turn == "270";
        if (name == names.end() || !known || used[static_cast<size_t>(name - names.begin())])
            refuse(faces);
        used[static_cast<size_t>(name - names.begin())] = true;
        found.push_back({static_cast<int>(name - names.begin()), std::stoi(turn) / 90});
    }
    if (found.size() != 6)
        refuse(faces);
    return found;
}

/// The cells of a sheet with the faces of somebody's choice, each with the axes that the sheet's kind gives it.
Cells ordered(CubeSheet sheet, const std::string& faces)
{
    Cells result = cells(sheet);
    if (faces.empty())
        return result;
    const std::vector<NamedFace> order = parse(faces);
    const Cells axes = isCross(sheet) ? horizontalCross : grid(1);
    for (size_t i = 0; i < result.size(); ++i) {
        const glm::ivec3 forward(cube_map::facePoint(order[i].face, 0, 0));
        const Cell& face = *std::find_if(axes.begin(), axes.end(), [&](const Cell& c) { return c.forward == forward; });
        glm::ivec3 right = face.right, down = face.down;
        for (int turn = 0; turn < order[i].quarterTurns; ++turn) { // clockwise: what was up is right
            const glm::ivec3 before = right;
            right = -down;
            down = before;
        }
        result[i] = {result[i].column, result[i].row, right, down, forward};
    }
    return result;
}

} // namespace

glm::ivec2 cellsOf(CubeSheet sheet)
{
    switch (sheet) {
    case CubeSheet::Stack:
        return {1, 6};
    case CubeSheet::Strip:
        return {6, 1};
    case CubeSheet::Grid3x2:
        return {3, 2};
    case CubeSheet::Grid2x3:
        return {2, 3};
    case CubeSheet::HorizontalCross:
        return {4, 3};
    case CubeSheet::VerticalCross:
        break;
    }
    return {3, 4};
}

void checkFaceOrder(const std::string& faces)
{
    if (!faces.empty())
        parse(faces);
}

EnvironmentMap cutUp(const Image& image, CubeSheet sheet, int border, const std::string& faces)
{
    const glm::ivec2 across = cellsOf(sheet);
    const int pitch = image.width / across.x, n = pitch - 2 * border;
    if (image.width != pitch * across.x || image.height != pitch * across.y || n < 1)
        throw InvalidArgument("an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                              " texels is no sheet of cube faces");
    EnvironmentMap map({Parameterization::Cube, n, 0});
    const auto dot = [](const glm::ivec3& a, const glm::ivec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const Cells sheetCells = ordered(sheet, faces), stack = grid(1);
    for (const Cell& face : stack)
        for (const Cell& cell : sheetCells) {
            if (cell.forward != face.forward)
                continue;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) { // whole numbers only
                    const glm::ivec3 point = (2 * x + 1 - n) * face.right + (2 * y + 1 - n) * face.down;
                    const int sheetX = cell.column * pitch + border + (dot(point, cell.right) + n - 1) / 2;
                    const int sheetY = cell.row * pitch + border + (dot(point, cell.down) + n - 1) / 2;
                    std::copy_n(image.texel(sheetX, sheetY), 3, map.image.texel(x, face.row * n + y));
                }
        }
    return map;
}

Image withBorders(const EnvironmentMap& cube, int border)
{
    const int n = cube.layout.size, pitch = n + 2 * border;
    Image result(pitch, 6 * pitch, cube.image.channels);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < pitch; ++y)
            for (int x = 0; x < pitch; ++x) {
                const Texel from = acrossSeam(cube.layout, {0, face * n}, x - border, face * n + y - border);
                std::copy_n(cube.image.texel(from.x, from.y), cube.image.channels, result.texel(x, face * pitch + y));
            }
    return result;
}

} // namespace mirrorball
