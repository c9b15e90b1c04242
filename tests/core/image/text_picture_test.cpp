#include "core/image/picture_grid.h"
#include "core/image/text_picture.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace mirrorball {
namespace {

TEST(TextPicture, HasADifferentLetterForEveryCharacter)
{
    std::set<std::vector<float>> letters;
    for (char c = ' '; c <= '~'; ++c) {
        const Image letter = textPicture(std::string(1, c), 1);
        EXPECT_EQ(letter.width, letterWidth);
        EXPECT_EQ(letter.height, textHeight);
        EXPECT_TRUE(letters.insert(letter.texels).second) << c;
    }
    EXPECT_EQ(textPicture("\xc3", 1), textPicture("\x7f", 1)); // boxes
}

// A letter that everyone knows the look of.
TEST(TextPicture, IsUprightAndScaled)
{
    const char* const rows[] = {"     ", "#####", "#    ", "#    ", "###  ", "#    ", "#    ", "#    ", "     "};
    for (const int scale : {1, 3}) {
        const Image letter = textPicture("F", scale);
        for (int y = 0; y < textHeight * scale; ++y)
            for (int x = 0; x < 5 * scale; ++x) {
                // The middle bar's length is the designer's choice.
                const char dot = rows[y / scale][x / scale];
                if (y / scale == 4 && x / scale > 2)
                    continue;
                EXPECT_EQ(*letter.texel(x, y) > 0.0f, dot == '#') << x << " " << y;
            }
    }
}

TEST(PictureGrid, HoldsEveryPictureOnceAndNothingElseInItsPlace)
{
    const PictureGrid grid{.columns = {"a", "b"}, .rows = {"1", "2", "3"}, .cellWidth = 5, .cellHeight = 4};
    int asked = 0;
    const Image whole = layOut(grid, [&](int row, int column) {
        ++asked;
        return Image(5, 4, 4, 10.0f + static_cast<float>(2 * row + column));
    });
    EXPECT_EQ(asked, 6);
    EXPECT_EQ(whole.width, sizeOf(grid).width);
    EXPECT_EQ(whole.height, sizeOf(grid).height);
    for (int cell = 0; cell < 6; ++cell) {
        int texels = 0;
        for (int i = 0; i < whole.width * whole.height; ++i)
            texels += whole.texels[static_cast<size_t>(4 * i)] == 10.0f + static_cast<float>(cell);
        EXPECT_EQ(texels, 5 * 4) << cell;
    }
}

TEST(PictureGrid, CutsLabelsThatDoNotFit)
{
    const PictureGrid grid{.columns = {std::string(500, 'x'), "b"}, .cellWidth = 40, .cellHeight = 20};
    const Image whole = layOut(grid, [](int, int) { return Image(40, 20, 4, 0.0f); });
    EXPECT_EQ(whole.width, 40 + 4 + 40);
    for (int y = 0; y < whole.height - 20; ++y) // nothing of the label in the gap
        for (int x = 40; x < 44; ++x)
            EXPECT_EQ(whole.texel(x, y)[0], whole.texel(whole.width - 1, 0)[0]);
}

} // namespace
} // namespace mirrorball
