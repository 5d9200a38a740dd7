// What a driver cannot do is told, or left.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/pose.h"
#include "render/gl/driver_limits.h"
#include "tests/render/mesh_support.h"
#include <epoxy/egl.h>
#include <epoxy/gl.h>

using namespace relievo;
using namespace relievo::test;

TEST(Limits, APictureThatDoesNotFitIsToldAndASmallerOneDrawn)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    Framebuffer framebuffer;
    const State state = stateOn("plane", "flat");
    Resources resources = resourcesOf(state);
    Renderer renderer;
    for (int i = 0; i < 2; ++i) { // again when asked again
        const auto made = framebuffer.resize(limit + 1, 16);
        ASSERT_FALSE(made);
        EXPECT_NE(message(made.error()).find(std::to_string(limit + 1) + "x16"), std::string::npos) << message(made.error());
    }
    const auto drawn
        = renderer.draw({state, 0, resources, {.framebuffer = framebuffer.handle(), .width = limit + 1, .height = 16}, "color"});
    ASSERT_FALSE(drawn);
    EXPECT_FALSE(drawn.error().hint.empty());
    EXPECT_TRUE(framebuffer.resize(32, 16));
    EXPECT_TRUE(renderer.draw({state, 0, resources, {.framebuffer = framebuffer.handle(), .width = 32, .height = 16}, "color"}));
}

TEST(Limits, MemoryThatRunsOutIsToldOnce)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    EXPECT_TRUE(memorySufficed());
    const auto real = epoxy_glGetError;
    static int left;
    left = 1;
    epoxy_glGetError = []() -> GLenum { return left-- > 0 ? GL_OUT_OF_MEMORY : GL_NO_ERROR; };
    const State state = stateOn("plane", "flat");
    Resources resources = resourcesOf(state);
    Renderer renderer;
    const auto drawn = drawPicture(renderer, state, 0, resources, "color", 32, 16, 1, false);
    EXPECT_FALSE(drawn);
    EXPECT_TRUE(drawPicture(renderer, state, 0, resources, "color", 32, 16, 1, false));
    epoxy_glGetError = real;
}

TEST(Limits, MorphTargetsThatDoNotFitAreTold)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const State state = stateOn("plane", "flat");
    Resources resources = resourcesOf(state);
    Mesh mesh = *resources.mesh;
    const auto deformation = std::make_shared<Deformation>();
    deformation->influences.resize(mesh.vertices.size());
    deformation->joints.resize(1);
    deformation->targets.push_back({"none", -1, 0.f, std::vector<MorphDelta>(mesh.vertices.size())});
    mesh.deformation = deformation;
    resources.mesh = std::make_shared<const Mesh>(mesh);
    Renderer renderer;
    EXPECT_TRUE(drawPicture(renderer, state, 0, resources, "color", 32, 16, 1, false));
    static auto real = epoxy_glGetIntegerv;
    epoxy_glGetIntegerv = [](GLenum name, GLint* value) {
        real(name, value);
        if (name == GL_MAX_TEXTURE_BUFFER_SIZE)
            *value = 8;
    };
    const auto drawn = drawPicture(renderer, state, 0, resources, "color", 32, 16, 1, false);
    epoxy_glGetIntegerv = real;
    ASSERT_FALSE(drawn);
    EXPECT_NE(message(drawn.error()).find("morph targets"), std::string::npos) << message(drawn.error());
}

TEST(Limits, AHeightMapThatDoesNotFitIsToldBeforeItIsSearched)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const HeightField field(16, 8, std::vector<float>(128, 0.5f));
    const std::vector<SearchRay> rays = {{{0.5, 0.5}, {0.1, 0.1}, 1.}};
    EXPECT_TRUE(traceRaysOnGpu("relief", Parameters(), &field, rays));
    static auto real = epoxy_glGetIntegerv;
    epoxy_glGetIntegerv = [](GLenum name, GLint* value) {
        real(name, value);
        if (name == GL_MAX_TEXTURE_SIZE)
            *value = 8;
    };
    const auto traced = traceRaysOnGpu("relief", Parameters(), &field, rays);
    epoxy_glGetIntegerv = real;
    ASSERT_FALSE(traced);
    EXPECT_NE(message(traced.error()).find("16 texels"), std::string::npos) << message(traced.error());
}

// A context without what is deprecated has no wide lines.
TEST(Limits, WiresAreNoError)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLContext before = eglGetCurrentContext();
    const EGLint configWish[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_TRUE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, configWish, &config, 1, &count);
    const EGLContext forward = eglCreateContext(display, count ? config : nullptr, EGL_NO_CONTEXT, contextWish);
    ASSERT_NE(forward, EGL_NO_CONTEXT);
    ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, forward));
    {
        State state = stateOn("plane", "flat");
        state.parameters.wireframe = true;
        Resources resources = resourcesOf(state);
        Renderer renderer;
        Framebuffer framebuffer;
        ASSERT_TRUE(framebuffer.resize(32, 32));
        glLineWidth(1.f); // libepoxy has found it then
        static auto real = epoxy_glLineWidth;
        static GLenum error;
        error = GL_NO_ERROR;
        epoxy_glLineWidth = [](GLfloat width) {
            real(width);
            error = glGetError();
        };
        EXPECT_TRUE(renderer.draw(
            {state, 0, resources, {.framebuffer = framebuffer.handle(), .width = 32, .height = 32, .lineWidth = 2.f}, "color"}));
        epoxy_glLineWidth = real;
        EXPECT_EQ(error, GLenum(GL_NO_ERROR));
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, before);
    eglDestroyContext(display, forward);
}
