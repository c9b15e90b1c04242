#include "gl_fixture.h"

using namespace mirrorball;
using namespace mirrorball::preview;

using ShaderProgramTest = mirrorball::test::GlTest;

TEST_F(ShaderProgramTest, ContextDescribesItself)
{
    EXPECT_NE(OffscreenContext().description().find("4.5"), std::string::npos);
}

TEST(ShaderSource, PutsMarkedFilesInOnce)
{
    const ShaderSource source = resolveIncludes("x", "#include \"lib/fresnel.glsl\"\n#include \"lib/fresnel.glsl\"\nvoid main() {}\n");
    const std::string text = source.text;
    const size_t first = text.find("float fresnelDielectric");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.find("float fresnelDielectric", first + 1), std::string::npos);
    EXPECT_EQ(text.find("#include"), std::string::npos);
    EXPECT_EQ(text.find("#pragma once"), std::string::npos);
}

TEST(ShaderSource, NamesAFileThatIsNotThere)
{
    try {
        resolveIncludes("x", "#include \"lib/no_such.glsl\"\n");
        FAIL() << "nothing was thrown";
    } catch (const WorkError& error) {
        EXPECT_NE(std::string(error.what()).find("lib/no_such.glsl"), std::string::npos);
    }
}

TEST_F(ShaderProgramTest, LogNamesTheFileAndLineOfAnError)
{
    const ShaderSource good = resolveIncludes("good.vert", "void main() { gl_Position = vec4(0.0); }\n");
    const ShaderSource bad = resolveIncludes("bad.frag", "#include \"lib/fresnel.glsl\"\n\nvoid main() { nonsense = 1.0; }\n");
    try {
        ShaderProgram(good, bad);
        FAIL() << "nothing was thrown";
    } catch (const WorkError& error) {
        EXPECT_NE(std::string(error.what()).find("bad.frag:3"), std::string::npos) << error.what();
    }
}
