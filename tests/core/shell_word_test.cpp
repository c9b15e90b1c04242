#include "core/base/shell_word.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mirrorball {
namespace {

TEST(ShellWord, IsReadByAShellAsItWasMeant)
{
    const test::TemporaryFolder folder;
    const std::string weird = "it's a \"$HOME\" `x`; rm *\n& \\ \xc3\xbc |";
    const std::string out = (folder / "out").string();
    ASSERT_EQ(std::system(("printf %s " + shellWord(weird) + " > " + out).c_str()), 0);
    EXPECT_EQ(test::readBytes(out), weird);
    EXPECT_EQ(shellWord(""), "''");
    EXPECT_EQ(shellWord("/a/b-c_1.exr"), "/a/b-c_1.exr");
    EXPECT_EQ(shellWord("~"), "'~'");
}

} // namespace
} // namespace mirrorball
