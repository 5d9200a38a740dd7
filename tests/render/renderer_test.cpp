// The renderer in a windowless context: pictures that are right, and nothing that a State does not use.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/scene/source.h"
#include "core/shader_text/shader_files.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "render/legend.h"
#include "render/windowless.h"
#include "tests/render/mesh_support.h"
#include <cmath>
#include <cstdlib>
#include <epoxy/gl.h>
#include <filesystem>
#include <gtest/gtest.h>

using namespace relievo;
using relievo::test::resourcesOf;
namespace fs = std::filesystem;

namespace {

// One context for all tests of the program: making one costs 50 ms.
WindowlessContext& context()
{
    static auto made = WindowlessContext::create();
    EXPECT_TRUE(made) << message(made.error());
    return *made;
}

State sampleState(const char* technique, const char* mesh = "plane")
{
    auto opened = openSource("sample:bricks@128", State());
    EXPECT_TRUE(opened);
    opened->state.panes = {Pane{technique, {}}};
    opened->state.mesh = mesh;
    return opened->state;
}

Image picture(
    Renderer& renderer, const State& state, Resources resources, const char* view, bool linear = false, int width = 96, int height = 64)
{
    auto image = drawPicture(renderer, state, 0, resources, view, width, height, 1, linear);
    EXPECT_TRUE(image) << message(image.error());
    return image ? *image : Image{};
}

double meanDifference(const Image& a, const Image& b)
{
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::abs(double(a.value(x, y, c)) - double(b.value(x, y, c)));
    return sum / double(a.texelCount() * 3);
}

// The camera straight above the plane, so that texture space and picture agree.
State fromAbove(State state)
{
    state.camera = {0.f, 90.f, 35.f, 1.2f, glm::vec3(0.f)};
    return state;
}

} // namespace

TEST(Renderer, EveryTechniqueAndViewDrawsFiniteValues)
{
    context();
    Renderer renderer;
    for (const char* mesh : {"plane", "sphere", "torus"})
        for (const TechniqueRow& technique : kTechniques) {
            if (technique.file.empty())
                continue;
            const State state = sampleState(std::string(technique.key).c_str(), mesh);
            Resources resources = resourcesOf(state);
            for (const ViewRow& view : kViews) {
                const Image image = picture(renderer, state, resources, std::string(view.key).c_str(), true, 48, 32);
                for (int y = 0; y < image.height; ++y)
                    for (int x = 0; x < image.width; ++x)
                        for (int c = 0; c < 4; ++c)
                            ASSERT_TRUE(std::isfinite(image.value(x, y, c))) << mesh << ' ' << technique.key << ' ' << view.key;
            }
        }
}

TEST(Renderer, TechniquesShowDifferentPictures)
{
    context();
    Renderer renderer;
    const State relief = sampleState("relief");
    Resources resources = resourcesOf(relief);
    const Image withRelief = picture(renderer, relief, resources, "shaded");
    for (const char* other : {"flat", "bump", "parallax"})
        EXPECT_GT(meanDifference(withRelief, picture(renderer, sampleState(other), resources, "shaded")), 0.003) << other;
    EXPECT_EQ(meanDifference(withRelief, picture(renderer, relief, resources, "shaded")), 0.); // a function of its arguments
}

TEST(Renderer, DepthStraightDownIsTheHeightMap)
{
    context();
    Renderer renderer;
    State state = fromAbove(sampleState("relief"));
    state.camera.distance = 300.f; // as good as parallel rays
    state.camera.fov = 0.18f;
    state.parameters.heightMips = false;
    state.parameters.minSteps = 256, state.parameters.maxSteps = 256, state.parameters.refineSteps = 12;
    Resources resources = resourcesOf(state);
    const int size = 64;
    const Image depth = picture(renderer, state, resources, "depth", true, size, size);
    const HeightField& field = *resources.material->height;
    const float halfWidth = 300.f * std::tan(0.09f * 3.14159265f / 180.f); // metres seen to each side
    int compared = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float px = halfWidth * (2.f * (float(x) + 0.5f) / size - 1.f), pz = halfWidth * (2.f * (float(y) + 0.5f) / size - 1.f);
            if (std::abs(px) > 0.45f || std::abs(pz) > 0.45f)
                continue;
            const glm::vec2 uv(px + 0.5f, pz + 0.5f); // u along +x, v along +z
            const HeightField::Corners c = field.corners(int(std::floor(uv.x * 128.f - 0.5f)), int(std::floor(uv.y * 128.f - 0.5f)));
            const auto [low, high] = std::minmax({c.h00, c.h10, c.h01, c.h11});
            EXPECT_GE(depth.value(x, y, 0), 1.f - high - 0.02f);
            EXPECT_LE(depth.value(x, y, 0), 1.f - low + 0.02f);
            ++compared;
        }
    EXPECT_GT(compared, 1500);
}

TEST(Renderer, ErrorIsSmallForManyStepsAndLargerForFew)
{
    context();
    Renderer renderer;
    State state = sampleState("relief");
    state.camera.pitch = 15.f;
    Resources resources = resourcesOf(state);
    const auto meanError = [&](int steps) {
        state.parameters.minSteps = state.parameters.maxSteps = steps;
        const Image error = picture(renderer, state, resources, "error", true);
        double sum = 0, covered = 0;
        for (int y = 0; y < error.height; ++y)
            for (int x = 0; x < error.width; ++x)
                if (error.value(x, y, 3) > 0.f)
                    sum += double(error.value(x, y, 0)), ++covered;
        EXPECT_GT(covered, 100);
        return sum / covered;
    };
    const double few = meanError(4), many = meanError(512);
    EXPECT_GT(few, 0.02);
    EXPECT_LT(many, 0.002);
}

TEST(Renderer, SelfShadowsDarkenAndCanBeTurnedOff)
{
    context();
    Renderer renderer;
    State state = sampleState("relief");
    state.parameters.lightPitch = 12.f;
    state.parameters.depth = 0.1f;
    Resources resources = resourcesOf(state);
    const auto shadowed = [&] {
        const Image shadow = picture(renderer, state, resources, "shadow", true);
        int dark = 0;
        for (int y = 0; y < shadow.height; ++y)
            for (int x = 0; x < shadow.width; ++x)
                dark += shadow.value(x, y, 0) < 0.5f && shadow.value(x, y, 0) != 0.0331f;
        return dark;
    };
    EXPECT_GT(shadowed(), 100);
    state.parameters.shadows = false;
    EXPECT_EQ(shadowed(), 0);
}

TEST(Renderer, FetchesFollowTheTechnique)
{
    context();
    Renderer renderer;
    State state = sampleState("flat");
    Resources resources = resourcesOf(state);
    EXPECT_EQ(renderer.measure(state, 0, resources, 1.5f)->meanFetches, 0.);
    state.panes[0].technique = "parallax";
    EXPECT_EQ(renderer.measure(state, 0, resources, 1.5f)->meanFetches, 1.);
    state.panes[0].technique = "relief";
    const auto measured = renderer.measure(state, 0, resources, 1.5f);
    EXPECT_GT(measured->meanFetches, 7.);
    EXPECT_LE(measured->maxFetches, 38.);
    EXPECT_GT(measured->covered, 0.1);
}

TEST(Renderer, UploadsOnlyWhatTheProgramReads)
{
    context();
    Renderer renderer;
    State state = sampleState("flat");
    Resources resources = resourcesOf(state);
    picture(renderer, state, resources, "color");
    EXPECT_EQ(renderer.textureCount(), 1); // the color map
    picture(renderer, state, resources, "shaded");
    EXPECT_EQ(renderer.textureCount(), 3); // with roughness and environment
    state.panes[0].technique = "relief";
    picture(renderer, state, resources, "shaded");
    EXPECT_EQ(renderer.textureCount(), 5); // with height and its slopes
}

TEST(Renderer, TilingMovesTheTexture)
{
    context();
    Renderer renderer;
    State state = fromAbove(sampleState("flat"));
    Resources resources = resourcesOf(state);
    const Image before = picture(renderer, state, resources, "color");
    state.parameters.offsetU = 1.f; // a whole tile
    EXPECT_LT(meanDifference(before, picture(renderer, state, resources, "color")), 1e-3);
    state.parameters.offsetU = 0.37f;
    EXPECT_GT(meanDifference(before, picture(renderer, state, resources, "color")), 0.01);
    state.parameters.offsetU = 0.f;
    state.parameters.rotation = 90.f;
    EXPECT_GT(meanDifference(before, picture(renderer, state, resources, "color")), 0.01);
}

TEST(Renderer, MissingHeightMapIsToldFlatStillDraws)
{
    context();
    Renderer renderer;
    State state = sampleState("relief");
    state.slots[std::size_t(MapKind::Height)] = {};
    Resources resources = resourcesOf(state);
    const auto drawn = drawPicture(renderer, state, 0, resources, "shaded", 32, 32, 1, false);
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().what.find("height map"), std::string::npos);
    for (const char* technique : {"flat", "bump"}) {
        state.panes[0].technique = technique;
        EXPECT_TRUE(drawPicture(renderer, state, 0, resources, "shaded", 32, 32, 1, false)) << technique;
    }
}

TEST(Renderer, SamplesSmoothTheOutline)
{
    context();
    Renderer renderer;
    const State state = sampleState("flat", "sphere");
    Resources resources = resourcesOf(state);
    const auto levels = [&](int samples) {
        const Image image = *drawPicture(renderer, state, 0, resources, "shadow", 64, 64, samples, false);
        int between = 0; // white inside, dark outside: grey is the smoothed outline
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                between += image.value(x, y, 0) > 0.3f && image.value(x, y, 0) < 0.95f;
        return between;
    };
    EXPECT_EQ(levels(1), 0);
    EXPECT_GT(levels(8), 40);
}

TEST(Renderer, HalfCoveredPixelsKeepTheirColour)
{
    context();
    Renderer renderer;
    State state = sampleState("flat", "sphere");
    state.parameters.background = Backdrop::Transparent;
    Resources resources = resourcesOf(state);
    const Image image = *drawPicture(renderer, state, 0, resources, "shadow", 64, 64, 16, false); // white inside
    int edge = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (const float alpha = image.value(x, y, 3); alpha > 0.f && alpha < 1.f) {
                ++edge;
                EXPECT_GT(image.value(x, y, 0), 0.95f); // not darkened by what is not there
            }
    EXPECT_GT(edge, 30);
}

TEST(Renderer, TransparentBackgroundHasNoAlpha)
{
    context();
    Renderer renderer;
    State state = sampleState("flat", "sphere");
    state.parameters.background = Backdrop::Transparent;
    const Image image = picture(renderer, state, resourcesOf(state), "shaded", false, 64, 64);
    EXPECT_EQ(image.value(0, 0, 3), 0.f);
    EXPECT_EQ(image.value(32, 32, 3), 1.f);
    state.parameters.background = Backdrop::Environment;
    EXPECT_EQ(picture(renderer, state, resourcesOf(state), "shaded", false, 64, 64).value(0, 0, 3), 1.f);
}

TEST(Renderer, TheGradientIsSoftGreyWhateverTheLight)
{
    context();
    Renderer renderer;
    State state = sampleState("flat", "sphere");
    state.parameters.background = Backdrop::Gradient;
    state.camera.distance = 8.f;
    const Image image = picture(renderer, state, resourcesOf(state), "shaded", false, 256, 256);
    const auto grey = [&](int x, int y) { return image.value(x, y, 1); };
    EXPECT_GT(grey(128, 60), grey(2, 2) + 0.05f) << "lighter behind the middle";
    for (int x = 0; x < 255; ++x) {
        EXPECT_NEAR(grey(x, 20), grey(x + 1, 20), 3.f / 255.f) << "no edge, no band";
        EXPECT_NEAR(image.value(x, 20, 0), image.value(x, 20, 2), 1e-3f);
    }
    state.parameters.exposure = 3.f;
    EXPECT_EQ(picture(renderer, state, resourcesOf(state), "shaded", false, 256, 256).value(2, 2, 1), grey(2, 2));
}

TEST(Renderer, BrokenShaderKeepsTheLastPictureAndNamesTheLine)
{
    context();
    const fs::path folder = fs::temp_directory_path() / "relievo_shader_test";
    fs::remove_all(folder);
    for (const ShaderFile& file : embeddedShaders()) {
        fs::create_directories((folder / file.name).parent_path());
        ASSERT_TRUE(writeAtomically(folder / file.name, file.text));
    }
    setenv("RELIEVO_SHADERS", folder.c_str(), 1);
    Renderer renderer;
    unsetenv("RELIEVO_SHADERS");
    const State state = sampleState("flat");
    Resources resources = resourcesOf(state);
    const Image good = picture(renderer, state, resources, "color");
    EXPECT_FALSE(renderer.shadersChanged());

    const fs::path view = folder / "views/color.glsl";
    const std::string text = *readText(view);
    ASSERT_TRUE(writeAtomically(view, "// broken\n" + text + "\nnonsense here;\n"));
    fs::last_write_time(view, fs::last_write_time(view) + std::chrono::seconds(2));
    EXPECT_TRUE(renderer.shadersChanged());
    Framebuffer target;
    target.resize(96, 64);
    const auto drawn = renderer.draw({state, 0, resources, {.framebuffer = target.handle(), .width = 96, .height = 64}, "color"});
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().what.find("views/color.glsl:"), std::string::npos) << drawn.error().what;
    std::vector<std::uint8_t> pixels(96 * 64 * 4); // still drawn with the program that linked
    glReadPixels(0, 0, 96, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    int same = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x)
            same += std::abs(int(pixels[std::size_t(((63 - y) * 96 + x) * 4)]) - int(std::lround(good.value(x, y, 0) * 255.f))) <= 1;
    EXPECT_EQ(same, 96 * 64);

    ASSERT_TRUE(writeAtomically(view, text));
    fs::last_write_time(view, fs::last_write_time(view) + std::chrono::seconds(4));
    EXPECT_EQ(meanDifference(good, picture(renderer, state, resources, "color")), 0.);
    fs::remove_all(folder);
}

// Each feature of a program has its own: an exact search knows the wrap mode beforehand.
TEST(Renderer, WrapOfAnExactSearchIsNotThatOfThePictureBefore)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = openSource("sample:cobblestones@64", State())->state;
    state.panes = {Pane{"cell-cone", {}}};
    state.parameters.depth = 0.4f, state.camera.pitch = 12.f;
    auto resources = *loadResources(state, {}, {});
    const auto depths = [&](Renderer& renderer) { return drawPicture(renderer, state, 0, resources, "depth", 96, 72, 1, true)->data; };
    Renderer renderer;
    const auto repeated = depths(renderer);
    state.parameters.wrap = Wrap::Clamp;
    Renderer fresh;
    const auto clamped = depths(renderer);
    EXPECT_NE(clamped, repeated);
    EXPECT_EQ(clamped, depths(fresh));
}

// A letter without a glyph would be left out of the legend.
TEST(Legend, WritesEveryUnit)
{
    const auto written = [](std::string_view unit) {
        Image picture{320, 240, 4, PixelType::U8, 8, false, std::vector<std::byte>(std::size_t(320) * 240 * 4)};
        drawLegend(picture, 1.f, unit);
        return picture.data;
    };
    for (const ViewRow& view : kViews)
        for (const char letter : view.unit)
            EXPECT_NE(written(std::string(1, letter)), written(" ")) << view.key << ": " << letter;
}
