#include "core/preview/mesh_picture.h"

#include <gtest/gtest.h>

#include <vector>

namespace mirrorball::preview {
namespace {

// A body fills the middle and leaves the corners free; its top is lit more than its underside; no two look alike.
TEST(MeshPicture, ShowsTheBodyLitFromAboveBeforeNothing)
{
    constexpr int edge = 64;
    std::vector<Image> before;
    for (const GeometryKind kind : {GeometryKind::Teapot, GeometryKind::Torus, GeometryKind::Sphere, GeometryKind::Box}) {
        const Image picture = meshPicture({.kind = kind}, edge);
        ASSERT_EQ(picture.width, edge);
        for (const int x : {0, edge - 1})
            for (const int y : {0, edge - 1})
                EXPECT_EQ(picture.texel(x, y)[3], 0.0f);
        int covered = 0;
        for (size_t i = 3; i < picture.texels.size(); i += 4)
            covered += picture.texels[i] == 1.0f;
        EXPECT_GT(covered, edge * edge / 10) << static_cast<int>(kind);
        for (const Image& other : before)
            EXPECT_NE(picture, other);
        before.push_back(picture);
    }
    const Image& ball = before[2];
    EXPECT_GT(ball.texel(edge / 2, edge / 4)[1], ball.texel(edge / 2, 3 * edge / 4)[1]);
}

} // namespace
} // namespace mirrorball::preview
