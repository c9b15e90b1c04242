#include "offscreen_context.h"

#include "core/base/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string_view>
#include <utility>

namespace mirrorball::preview {

namespace {

constexpr const char* remedy = "install Mesa's software renderer: apt install libegl1 libgl1-mesa-dri";

bool hasWord(const char* words, std::string_view word)
{
    const std::string all = words ? ' ' + std::string(words) + ' ' : std::string();
    return all.find(' ' + std::string(word) + ' ') != std::string::npos;
}

[[noreturn]] void fail(const std::string& what) { throw WorkError("no OpenGL 4.5 context without a display: " + what + "; " + remedy); }

// The EXT entry point, not eglGetPlatformDisplay: libepoxy looks that one up by EGL version, which needs a display first, and ends
// the process when there is none.
EGLDisplay surfacelessDisplay()
{
    if (!epoxy_has_egl())
        fail("libEGL is not installed");
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasWord(extensions, "EGL_EXT_platform_base") || !hasWord(extensions, "EGL_MESA_platform_surfaceless"))
        fail("EGL lacks EGL_MESA_platform_surfaceless");
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        fail("EGL's surfaceless display does not start");
    return display;
}

} // namespace

OffscreenContext::OffscreenContext()
{
    const EGLDisplay display = surfacelessDisplay();
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!hasWord(extensions, "EGL_KHR_no_config_context") || !hasWord(extensions, "EGL_KHR_surfaceless_context"))
        fail("EGL cannot make a context without a surface");
    if (!eglBindAPI(EGL_OPENGL_API))
        fail("EGL offers no desktop OpenGL");
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT)
        fail("the driver offers no OpenGL 4.5 core profile");
    m_display = display;
    m_context = context;
    makeCurrent();
}

// The display is one per process and shared by every context in it: it is not terminated here.
OffscreenContext::~OffscreenContext()
{
    if (!m_context)
        return;
    if (eglGetCurrentContext() == m_context)
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
}

OffscreenContext::OffscreenContext(OffscreenContext&& other) noexcept
    : m_display(std::exchange(other.m_display, nullptr)), m_context(std::exchange(other.m_context, nullptr))
{
}

OffscreenContext& OffscreenContext::operator=(OffscreenContext&& other) noexcept
{
    std::swap(m_display, other.m_display);
    std::swap(m_context, other.m_context);
    return *this;
}

void OffscreenContext::makeCurrent()
{
    if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
        fail("the context cannot be made current on this thread");
}

CurrentContextGuard::CurrentContextGuard()
{
    const bool hasEgl = epoxy_has_egl();
    m_display = hasEgl ? eglGetCurrentDisplay() : EGL_NO_DISPLAY;
    m_context = hasEgl ? eglGetCurrentContext() : EGL_NO_CONTEXT;
    m_draw = hasEgl ? eglGetCurrentSurface(EGL_DRAW) : EGL_NO_SURFACE;
    m_read = hasEgl ? eglGetCurrentSurface(EGL_READ) : EGL_NO_SURFACE;
}

// Where nothing was current, what is current now is released: its display says so.
CurrentContextGuard::~CurrentContextGuard()
{
    if (!epoxy_has_egl() || eglGetCurrentContext() == m_context)
        return;
    eglMakeCurrent(m_context == EGL_NO_CONTEXT ? eglGetCurrentDisplay() : m_display, m_draw, m_read, m_context);
}

std::string OffscreenContext::description() const
{
    return reinterpret_cast<const char*>(glGetString(GL_VERSION)) + std::string(", ") +
           reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

} // namespace mirrorball::preview
