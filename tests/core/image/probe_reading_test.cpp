#include "core/image/probe_reading.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

double distance(const glm::dmat3& a, const glm::dmat3& b)
{
    double largest = 0.0;
    for (int i = 0; i < 9; ++i)
        largest = std::max(largest, std::abs(a[i / 3][i % 3] - b[i / 3][i % 3]));
    return largest;
}

TEST(ProbeReading, ATurnAboutYIsAYaw)
{
    const glm::dmat3 turn = orientation({.rotateDeg = {33.0, 0.0, 0.0}});
    for (const glm::dvec3& d : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0.36, 0.48, 0.8}})
        EXPECT_LT(glm::distance(turn * d, yawed(d, 33.0 * pi / 180.0)), 1e-12);
}

TEST(ProbeReading, AQuaternionAndItsAnglesAreOneTurn)
{
    for (const glm::dvec3& angles : {glm::dvec3(10, 20, 30), {-170, 80, 5}, {90, 90, 0}, {0, -90, 40}, {120, 0, -179}}) {
        const auto half = [](double degrees) { return 0.5 * degrees * pi / 180.0; };
        // Hamilton's product of the three turns, Y X Z, written out.
        const double cy = std::cos(half(angles[0])), sy = std::sin(half(angles[0])), cx = std::cos(half(angles[1])),
                     sx = std::sin(half(angles[1])), cz = std::cos(half(angles[2])), sz = std::sin(half(angles[2]));
        const double w = cy * cx * cz + sy * sx * sz, x = cy * sx * cz + sy * cx * sz, y = sy * cx * cz - cy * sx * sz,
                     z = cy * cx * sz - sy * sx * cz;
        std::ostringstream text;
        text.precision(17);
        text << 3 * w << ',' << 3 * x << ", " << 3 * y << ',' << 3 * z; // of any length
        const glm::dvec3 parsed = parseRotation("--rotate", text.str());
        EXPECT_LT(distance(orientation({.rotateDeg = parsed}), orientation({.rotateDeg = angles})), 1e-6) << text.str();
    }
    EXPECT_EQ(parseRotation("--rotate", "1,-2,3.5"), glm::dvec3(1, -2, 3.5));
}

TEST(ProbeReading, RefusesWhatIsNoRotation)
{
    for (const char* wrong : {"", "1", "1,2", "1,2,3,4,5", "a,b,c", "1,2,", "nan,0,0", "inf,0,0", "0,0,0,0", "1 2 3", "1,2,3x", "1e9,0,0"})
        EXPECT_THROW(parseRotation("--rotate", wrong), InvalidArgument) << wrong;
}

} // namespace
} // namespace mirrorball
