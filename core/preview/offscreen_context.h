#pragma once

#include <string>

namespace mirrorball::preview {

/// An OpenGL 4.5 core context without a window: EGL's surfaceless platform, which needs no display, no X server and no GPU.
/// The renderer does not depend on it; it draws in any current 4.5 core context, such as a Qt widget's.
/// One thread at a time may have it current.
class OffscreenContext {
public:
    /// Creates the context and makes it current on this thread.
    /// @throws WorkError saying what is missing and what to install
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(OffscreenContext&& other) noexcept;
    OffscreenContext& operator=(OffscreenContext&& other) noexcept;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Makes the context current on the calling thread. @throws WorkError
    void makeCurrent();
    /// Version and renderer of the context, for logs: "4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string description() const;

private:
    void* m_display = nullptr; // EGLDisplay
    void* m_context = nullptr; // EGLContext
};

/// Remembers which EGL context is current on this thread, and makes it current again at the end of its life.
class CurrentContextGuard {
public:
    CurrentContextGuard();
    ~CurrentContextGuard();
    CurrentContextGuard(const CurrentContextGuard&) = delete;
    CurrentContextGuard& operator=(const CurrentContextGuard&) = delete;

private:
    void *m_display, *m_context, *m_draw, *m_read;
};

} // namespace mirrorball::preview
