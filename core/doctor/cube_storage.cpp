#include "orientation.h"

#include "core/sphere/cube_map.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace mirrorball {

TurnedTexel turnedTexel(FaceTurn turn, int n, int x, int y)
{
    for (int k = 0; k < (turn & 3); ++k) { // undo a turn clockwise: what is at the right was at the top
        const int before = x;
        x = y;
        y = n - 1 - before;
    }
    return {(turn & 4) != 0 ? n - 1 - x : x, y};
}

const std::vector<CubeStorage>& allCubeStorages()
{
    static const std::vector<CubeStorage> storages = [] {
        std::vector<CubeStorage> result;
        constexpr int n = 4;
        std::array<int, 3> order{0, 1, 2};
        do {
            for (int signs = 0; signs < 8; ++signs) {
                glm::dmat3 axes(0.0);
                for (int c = 0; c < 3; ++c)
                    axes[c][order[static_cast<size_t>(c)]] = (signs >> c & 1) != 0 ? -1.0 : 1.0;
                for (FaceTurn turn = 0; turn < allFaceTurns; ++turn) {
                    CubeStorage storage{axes, turn, {}};
                    for (int f = 0; f < 6; ++f) {
                        // Three texels of the face tell where it comes from.
                        const auto source = [&](int x, int y) {
                            const TurnedTexel p = turnedTexel(turn, n, x, y);
                            const glm::dvec3 e = cube_map::facePoint(f, (2.0 * p.x + 1.0) / n - 1.0, (2.0 * p.y + 1.0) / n - 1.0);
                            return glm::ivec2(glm::floor(cube_map::coordinate(n, axes * e)));
                        };
                        FacePlace& place = storage.places[static_cast<size_t>(f)];
                        place.face = source(0, 0).y / n;
                        for (FaceTurn t = 0; t < allFaceTurns; ++t) {
                            const auto agrees = [&](int x, int y) {
                                const TurnedTexel p = turnedTexel(t, n, x, y);
                                return source(x, y) == glm::ivec2(p.x, place.face * n + p.y);
                            };
                            if (agrees(0, 0) && agrees(n - 1, 0) && agrees(0, n - 1))
                                place.turn = t;
                        }
                    }
                    result.push_back(storage);
                }
            }
        } while (std::next_permutation(order.begin(), order.end()));
        return result;
    }();
    return storages;
}

std::string faceName(int face)
{
    static constexpr std::array<const char*, 6> names{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
    return names[static_cast<size_t>(face)];
}

std::string describeTurn(FaceTurn turn)
{
    static constexpr std::array<const char*, 8> words{"",
                                                      "turned 90 degrees clockwise",
                                                      "turned by 180 degrees",
                                                      "turned 90 degrees counterclockwise",
                                                      "mirrored left to right",
                                                      "mirrored left to right, then turned 90 degrees clockwise",
                                                      "upside down (rows bottom up)",
                                                      "mirrored left to right, then turned 90 degrees counterclockwise"};
    return words[static_cast<size_t>(turn)];
}

std::string describe(const Orientation& found)
{
    const glm::dmat3 mirror(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    std::string text;
    if (found.storage.axes == glm::dmat3(1.0)) {
        text = "not mirrored";
    } else if (found.storage.axes == mirror) {
        text = "mirrored in X";
    } else {
        text = found.mirrored() ? "mirrored, " : "";
        text += "direction (x, y, z) shows (";
        for (int row = 0; row < 3; ++row)
            for (int c = 0; c < 3; ++c)
                if (const double sign = found.storage.axes[c][row]; sign != 0.0)
                    text += std::string(row > 0 ? ", " : "") + (sign < 0.0 ? "-" : "") + "xyz"[c];
        text += ")";
    }
    if (found.storage.turn == rowsBottomUp)
        text += ", rows bottom up";
    else if (found.storage.turn != 0)
        text += ", every face " + describeTurn(found.storage.turn);
    if (found.storage.axes == mirror && std::abs(std::abs(found.yaw) - pi) < 1e-9)
        return "mirrored in Z" + text.substr(std::string("mirrored in X").size());
    if (std::abs(found.yaw) > 1e-9) {
        std::array<char, 64> yaw{};
        std::snprintf(yaw.data(), yaw.size(), ", turned by %.4g degrees about +Y", found.yaw * 180.0 / pi);
        text += yaw.data();
    }
    return text;
}

} // namespace mirrorball
