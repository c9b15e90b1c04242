#include "core/base/error.h"
#include "core/base/failure.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(ShownPath, IsThePathWhereThatIsALineOfOrdinaryLength)
{
    EXPECT_EQ(shownPath("light/été 1.hdr"), "light/été 1.hdr");
    EXPECT_EQ(shownPath(std::string(300, 'x')), std::string(300, 'x'));
}

TEST(ShownPath, HasNoControlCharacters) { EXPECT_EQ(shownPath("a\n\x1b[31m\x7f.exr"), "a??[31m?.exr"); }

TEST(ShownPath, KeepsTheEndsOfALongPathAndCutsBetweenCharacters)
{
    const std::string shown = shownPath("/home/" + std::string(100000, 'x') + "/sky.hdr");
    EXPECT_LT(shown.size(), 300u);
    EXPECT_TRUE(shown.starts_with("/home/xxx") && shown.ends_with("xxx/sky.hdr")) << shown;
    for (int shift = 0; shift < 3; ++shift) { // three bytes each
        std::string euros(static_cast<size_t>(shift), 'x');
        for (int i = 0; i < 200; ++i)
            euros += "€";
        const std::string cut = shownPath(euros);
        EXPECT_EQ((cut.find("...") - static_cast<size_t>(shift)) % 3, 0u) << cut;
        EXPECT_EQ((cut.size() - cut.find("...") - 3) % 3, 0u) << cut;
    }
}

TEST(FileErrors, ShowThePathInOneLine) { EXPECT_STREQ(FileError("a\nb.hdr", "is missing").what(), "a?b.hdr: is missing"); }

TEST(Failure, WhateverIsThrownBecomesALine)
{
    EXPECT_EQ(failureOf([] {}), "");
    EXPECT_EQ(failureOf([] { throw InvalidArgument("size: must be 1"); }), "size: must be 1");
    EXPECT_NE(failureOf([] { throw std::bad_alloc(); }).find("not enough memory"), std::string::npos);
    EXPECT_EQ(failureOf([] { throw std::length_error("too long"); }), "too long");
    EXPECT_NE(failureOf([] { throw std::runtime_error(""); }), "");
    EXPECT_NE(failureOf([] { throw 1; }), "");
}

} // namespace
} // namespace mirrorball
