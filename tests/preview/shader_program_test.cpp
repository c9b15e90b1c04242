#include "gl_fixture.h"

using namespace mirrorball;
using namespace mirrorball::preview;

using ShaderProgramTest = mirrorball::test::GlTest;

TEST_F(ShaderProgramTest, ContextDescribesItself) { EXPECT_NE(OffscreenContext().description().find("4.5"), std::string::npos); }

TEST_F(ShaderProgramTest, MarkedFilesCountOnceAndCountAfterAFalseCondition)
{
    const ShaderSource vertex = resolveIncludes("good.vert", "void main() { gl_Position = vec4(0.0); }\n");
    const ShaderSource fragment = resolveIncludes("x", "#if 0\n#include \"lib/fresnel.glsl\"\n#endif\n#include \"lib/fresnel.glsl\"\n"
                                                       "#include \"lib/fresnel.glsl\"\nout vec4 c;\n"
                                                       "void main() { c = vec4(fresnelDielectric(0.5, 1.25)); }\n");
    EXPECT_EQ(fragment.text.find("#include"), std::string::npos);
    EXPECT_EQ(fragment.text.find("#pragma once"), std::string::npos);
    EXPECT_NO_THROW(ShaderProgram(vertex, fragment));
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
