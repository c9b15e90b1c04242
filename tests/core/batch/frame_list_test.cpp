#include "core/batch/frame_list.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(FrameList, ReadsRangesStepsAndLists)
{
    EXPECT_EQ(parseFrames("7"), std::vector<int>({7}));
    EXPECT_EQ(parseFrames("1-4"), std::vector<int>({1, 2, 3, 4}));
    EXPECT_EQ(parseFrames("1-10x4"), std::vector<int>({1, 5, 9}));
    EXPECT_EQ(parseFrames("9,1-2,20-30x10"), std::vector<int>({9, 1, 2, 20, 30}));
    EXPECT_EQ(parseFrames("0-999999").size(), 1'000'000u);
}

TEST(FrameList, RefusesWhatIsNoListOfFrames)
{
    for (const char* text :
         {"", "a", "1-", "-1", "4-1", "1-4x0", "1-4x", "1,,2", "1, 2", "1-2-3", "1-4,4", "99999999999", "0-1000000", "1 "})
        EXPECT_THROW(parseFrames(text), InvalidArgument) << text;
}

TEST(FrameList, PutsAFrameIntoANameWithAsManyDigitsAsItHasMarks)
{
    EXPECT_EQ(withFrame("a.####.exr", 7), "a.0007.exr");
    EXPECT_EQ(withFrame("a.####.exr", 12345), "a.12345.exr");
    EXPECT_EQ(withFrame("#/##/{frame}", 7), "7/07/7");
    EXPECT_EQ(withFrame("plain %s {stem}", 7), "plain %s {stem}");
    EXPECT_TRUE(namesFrame("a#") && namesFrame("{frame}") && !namesFrame("a{stem}"));
}

} // namespace
} // namespace mirrorball
