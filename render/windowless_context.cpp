// An EGL context without any surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/windowless.h"
#include <cstring>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace relievo {

struct WindowlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    ~Impl()
    {
        if (display == EGL_NO_DISPLAY)
            return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        // The display is the process's: other contexts may live on it, and unloading the driver makes its own data look leaked.
    }
};

WindowlessContext::WindowlessContext(std::unique_ptr<Impl> impl) : m(std::move(impl)) { }
WindowlessContext::WindowlessContext(WindowlessContext&&) noexcept = default;
WindowlessContext& WindowlessContext::operator=(WindowlessContext&&) noexcept = default;
WindowlessContext::~WindowlessContext() = default;

namespace {
constexpr const char* kNeeded = "Install an OpenGL 4.1 driver with EGL (Debian: libgl1-mesa-dri and libegl1)";

EGLDisplay displayWithoutSurface()
{
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless"))
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}
} // namespace

Expected<WindowlessContext> WindowlessContext::create()
{
    auto impl = std::make_unique<Impl>();
    impl->display = displayWithoutSurface();
    EGLint major = 0, minor = 0;
    if (impl->display == EGL_NO_DISPLAY || !eglInitialize(impl->display, &major, &minor)) {
        impl->display = EGL_NO_DISPLAY;
        return failure(ErrorCode::Driver, "OpenGL", "there is no EGL display to draw without a window", kNeeded);
    }
    const EGLint configWish[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_API);
    eglChooseConfig(impl->display, configWish, &config, 1, &count);
    const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    impl->context = eglCreateContext(impl->display, count ? config : nullptr, EGL_NO_CONTEXT, contextWish);
    if (impl->context == EGL_NO_CONTEXT || !eglMakeCurrent(impl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl->context)) {
        const char* vendor = eglQueryString(impl->display, EGL_VENDOR);
        return failure(ErrorCode::Driver, "OpenGL",
            std::string("the driver (") + (vendor ? vendor : "unknown") + ") gives no OpenGL 4.1 core context", kNeeded);
    }
    return WindowlessContext(std::move(impl));
}

} // namespace relievo
