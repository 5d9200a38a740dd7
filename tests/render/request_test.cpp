// What a picture is asked for: exact answers of another picture are not taken, passes that are not wanted cost nothing, and nothing that
// is kept from picture to picture is ever stale.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes.h"
#include "tests/render/mesh_support.h"
#include <epoxy/gl.h>

using namespace relievo;
using namespace relievo::test;

TEST(DrawRequest, TakesTheExactAnswerOfThisVeryPicture)
{
    State state = stateOn("sphere");
    const Resources resources = resourcesOf(state);
    Warnings coarse;
    const auto exact = exactDistances(state, 0, resources, 32, 24, coarse);
    ASSERT_TRUE(exact);
    const auto isTaken = [&](const State& asked, int width, int height, const Resources& data) {
        return DrawRequest(asked, 0, data, {.width = width, .height = height}).compareWith(*exact);
    };
    EXPECT_TRUE(isTaken(state, 32, 24, resources));
    EXPECT_FALSE(isTaken(state, 24, 32, resources));
    State other = state;
    other.camera.pitch += 0.1f;
    EXPECT_FALSE(isTaken(other, 32, 24, resources));
    other = state;
    other.panes[0].camera = state.camera;
    EXPECT_TRUE(isTaken(other, 32, 24, resources)) << "the same camera, though the pane's own";
    other.panes[0].camera->fov = 40.f;
    EXPECT_FALSE(isTaken(other, 32, 24, resources));
    other = state;
    other.parameters.depth *= 2.f;
    EXPECT_FALSE(isTaken(other, 32, 24, resources));
    other = state;
    other.parameters.exposure = 2.f, other.parameters.errorRange = 0.5f, setView(other, "error");
    EXPECT_TRUE(isTaken(other, 32, 24, resources)) << "colours and views do not move the surface";
    Resources otherMesh = resources;
    otherMesh.mesh = std::make_shared<const Mesh>(*resources.mesh);
    EXPECT_FALSE(isTaken(state, 32, 24, otherMesh));
    DrawRequest request(state, 0, resources, {.width = 32, .height = 24});
    EXPECT_TRUE(request.compareWith(*exact));
    EXPECT_FALSE(request.compareWith(nullptr));
    EXPECT_FALSE(request.exact());
}

TEST(Passes, AreDrawnWhereTheyAreWanted)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Framebuffer framebuffer;
    ASSERT_TRUE(framebuffer.resize(16, 12));
    const auto wanted = [&](const State& state) {
        const Resources resources = resourcesOf(state);
        const DrawRequest request(state, 0, resources, {.framebuffer = framebuffer.handle(), .width = 16, .height = 12});
        DrawContext draw;
        const auto frame = prepareFrame(draw, request);
        EXPECT_TRUE(frame);
        std::string keys;
        for (const PassRow& pass : kPasses)
            if (frame && pass.isWanted(*frame))
                keys += std::string(pass.key) + ' ';
        return keys;
    };
    State state = stateOn("sphere");
    EXPECT_EQ(wanted(state), "surface ");
    state.parameters.wireframe = state.parameters.objectShadows = true;
    state.parameters.background = Backdrop::Environment;
    EXPECT_EQ(wanted(state), "shadow-map surface wireframe background ");
    state.parameters.objectShadows = false, state.parameters.ground = true;
    EXPECT_EQ(wanted(state), "shadow-map surface wireframe background ground ");
    state.camera.pitch = -30.f; // from below
    EXPECT_EQ(wanted(state), "surface wireframe background ");
    state.camera.pitch = 30.f;
    setView(state, "fetches"); // is not lit, and lies on a plain ground
    EXPECT_EQ(wanted(state), "surface wireframe ");
}

// A renderer that has drawn another value before draws the same picture as one that has not, whatever the parameter: shadow maps,
// programs and poses follow. Shadows between objects are on, so that a stale shadow map would show.
TEST(Kept, IsNeverStale)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = stateOn("character", "relief");
    Parameters& p = state.parameters;
    p.objectShadows = true, p.shadowMapSize = 256, p.minSteps = p.maxSteps = 6;
    Resources resources = resourcesOf(state);
    const auto draw = [&](Renderer& renderer, const State& drawn) {
        const auto image = drawPicture(renderer, drawn, 0, resources, "shaded", 48, 36, 1, true);
        EXPECT_TRUE(image);
        return image.value_or(Image());
    };
    for (const ParameterRow& row : kParameters) {
        State changed = state;
        const Value value = get(p, row);
        if (const float* number = std::get_if<float>(&value)) // a little, as far as the range allows
            set(changed.parameters, row,
                clamped(row, *number + (*number + 0.1f * (row.max - row.min) > row.max ? -0.1f : 0.1f) * std::min(row.max - row.min, 4.f)));
        else if (const int* whole = std::get_if<int>(&value))
            set(changed.parameters, row, clamped(row, *whole == int(row.max) ? *whole - 1 : *whole + 1));
        else if (const bool* on = std::get_if<bool>(&value))
            set(changed.parameters, row, !*on);
        else
            set(changed.parameters, row, Value(glm::vec3(0.5f)));
        Renderer used, fresh;
        draw(used, state);
        EXPECT_EQ(draw(used, changed).data, draw(fresh, changed).data) << row.key;
    }
}

// A picture that is drawn in slices is the same, its shadow map too, which is not cut.
TEST(Request, SlicesMakeTheWholePicture)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    constexpr int kWidth = 80, kHeight = 61;
    State state = stateOn("spheres");
    state.parameters.objectShadows = true;
    const Resources resources = resourcesOf(state);
    const auto drawn = [&](std::initializer_list<int> ends) {
        Renderer renderer;
        Framebuffer framebuffer;
        EXPECT_TRUE(framebuffer.resize(kWidth, kHeight));
        int row = 0;
        for (const int end : ends) {
            EXPECT_TRUE(renderer.draw({state, 0, resources,
                {.framebuffer = framebuffer.handle(),
                    .width = kWidth,
                    .height = kHeight,
                    .jitter = {0.2f, -0.3f},
                    .firstRow = row,
                    .rows = end - row}}));
            row = end;
        }
        EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
        std::vector<unsigned char> pixels(kWidth * kHeight * 4);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.handle());
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    };
    const auto whole = drawn({kHeight});
    EXPECT_EQ(drawn({7, 8, 40, kHeight}), whole);
    EXPECT_NE(drawn({7}), whole);
}
