#include "sphere_drawer.h"

#include "offscreen_context.h"
#include "render_target.h"
#include "renderer.h"

#include "core/base/error.h"

#include <epoxy/gl.h>

namespace mirrorball::preview {

namespace {

constexpr int width = 640, height = 480;
constexpr int sphereLevel = 15; ///< 12 * 15^2 triangles

class SphereDrawer : public MapDrawer {
public:
    SphereDrawer() : m_target(width, height, 1, GL_RGBA8, 1, GL_NONE)
    {
        m_settings.width = width;
        m_settings.height = height;
        m_settings.samples = 1;
        m_settings.geometry.mesh = std::make_shared<const Mesh>(sphereMesh(1.0f, sphereLevel));
        m_settings.background = {.kind = Backdrop::Color, .color = glm::vec3(0.0f)};
    }

    ~SphereDrawer() override
    {
        const CurrentContextGuard guard;
        m_context.makeCurrent();
        m_renderer.release();
        m_target = {};
    }

    void draw(const std::shared_ptr<const std::vector<EnvironmentMap>>& levels) override
    {
        const CurrentContextGuard guard;
        m_context.makeCurrent();
        m_renderer.drawDisplay(m_settings, {.specular = levels}, {.framebuffer = m_target.framebuffer});
        glFinish();
    }

    std::string description() override
    {
        const CurrentContextGuard guard;
        m_context.makeCurrent();
        return std::to_string(width) + " x " + std::to_string(height) + ", " + m_context.description();
    }

private:
    OffscreenContext m_context; // first, so that it outlives what lives in it
    RenderTarget m_target;
    Renderer m_renderer{};
    RenderSettings m_settings{};
};

} // namespace

std::shared_ptr<MapDrawer> sphereDrawer()
{
    const CurrentContextGuard guard;
    try {
        return std::make_shared<SphereDrawer>();
    } catch (const WorkError&) {
        return nullptr;
    }
}

} // namespace mirrorball::preview
