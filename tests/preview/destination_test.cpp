#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using DestinationTest = mirrorball::test::GlTest;

namespace {

RenderSettings view()
{
    RenderSettings settings;
    settings.width = 96;
    settings.height = 64;
    settings.camera.yaw = 0.6f;
    return settings;
}

RenderMaps maps()
{
    const MapLevels map = asLevels(environmentFrom({Parameterization::Octahedral, 64, 0}, smoothRadiance));
    return {map, map, map};
}

// Names of every kind that are alive in the current context.
int livingObjects()
{
    int count = 0;
    for (GLuint name = 1; name < 2000; ++name)
        count +=
            glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsVertexArray(name) + glIsProgram(name) + glIsSampler(name);
    return count;
}

} // namespace

TEST_F(DestinationTest, APictureAtAnOffsetIsThePictureAndTouchesNothingElse)
{
    Renderer renderer;
    const RenderSettings settings = view();
    const RenderMaps given = maps();
    const Image expected = renderer.renderDisplay(settings, given);
    const RenderTarget window(150, 100, 1, GL_RGBA8, 1, GL_NONE);
    const glm::vec4 marked(1.0f, 0.0f, 1.0f, 0.0f);
    glClearNamedFramebufferfv(window.framebuffer, GL_COLOR, 0, &marked.x);
    renderer.drawDisplay(settings, given, {.framebuffer = window.framebuffer, .x = 20, .y = 10});
    const Image image = readImage(window);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 150; ++x) {
            const int px = x - 20, py = y - (100 - 10 - settings.height);
            const bool isInside = px >= 0 && px < settings.width && py >= 0 && py < settings.height;
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(image.texel(x, y)[c], isInside ? expected.texel(px, py)[c] : marked[c]) << x << ' ' << y;
        }
}

TEST_F(DestinationTest, TwoClippedHalvesMakeAWipe)
{
    Renderer renderer;
    RenderSettings a = view(), b = view();
    b.exposure = 1.0f;
    const RenderMaps given = maps();
    const Image left = renderer.renderDisplay(a, given), right = renderer.renderDisplay(b, given);
    const RenderTarget window(a.width, a.height, 1, GL_RGBA8, 1, GL_NONE);
    renderer.drawDisplay(a, given, {.framebuffer = window.framebuffer, .clip = PixelRectangle{0, 0, 41, a.height}});
    renderer.drawDisplay(b, given, {.framebuffer = window.framebuffer, .clip = PixelRectangle{41, 0, a.width, a.height}});
    const Image image = readImage(window);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            ASSERT_EQ(image.texel(x, y)[1], (x < 41 ? left : right).texel(x, y)[1]) << x << ' ' << y;
}

// So the studio draws a dragged material: over the picture before, within that part alone.
TEST_F(DestinationTest, AMaterialDrawnOverAnotherWithinTheObjectsPartIsItsWholePicture)
{
    Renderer renderer;
    const RenderMaps given = maps();
    RenderSettings before = view();
    before.samples = 1;
    RenderSettings after = before;
    after.material.diffuse = glm::vec3(0.3f, 0.8f, 0.1f);
    after.samples = 4;
    const PixelRectangle part = renderer.objectPart(after);
    ASSERT_LT(part.width * part.height, after.width * after.height); // otherwise nothing is shown
    const RenderTarget window(before.width, before.height, 1, GL_RGBA8, 1, GL_NONE);
    renderer.drawDisplay(before, given, {.framebuffer = window.framebuffer});
    const Image old = readImage(window);
    renderer.drawDisplay(after, given, {.framebuffer = window.framebuffer, .clip = part});
    const Image drawn = readImage(window);
    EXPECT_EQ(drawn.texels, renderer.renderDisplay(after, given).texels);
    EXPECT_NE(drawn.texels, old.texels);
}

TEST_F(DestinationTest, AReleasedRendererLeavesNothingBehindAndDrawsAgainInAnotherContext)
{
    const RenderSettings settings = view();
    const RenderMaps given = maps();
    const int before = livingObjects();
    Renderer renderer;
    const Image first = renderer.renderDisplay(settings, given);
    renderer.renderBuffers(settings);
    renderer.pick(settings, 40, 30);
    EXPECT_GT(livingObjects(), before);
    renderer.release();
    EXPECT_EQ(livingObjects(), before);
    {
        OffscreenContext other;
        EXPECT_EQ(renderer.renderDisplay(settings, given).texels, first.texels);
        renderer.release();
    }
    SUCCEED();
}
