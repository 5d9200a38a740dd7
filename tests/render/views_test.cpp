// What views show: colours as they are stored, penumbras that samples smooth, frames where derivatives are defined.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/views.h"
#include "tests/render/mesh_support.h"

using namespace relievo;
using namespace relievo::test;

namespace {

// A plane that fills the picture, seen from above.
State filling(const char* technique)
{
    State state = stateOn("plane", technique);
    state.camera = {0.f, 90.f, 35.f, 0.5f, glm::vec3(0.f)};
    return state;
}

} // namespace

TEST(Views, BaseColorIsNotLit)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = filling("flat");
    Resources resources = resourcesOf(state);
    Material material = *resources.material;
    constexpr int kTexel[] = {200, 100, 50};
    Image image{4, 4, 3, PixelType::U8, 8, false, std::vector<std::byte>(48)};
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = std::byte(kTexel[i % 3]);
    material.maps[std::size_t(MapKind::Color)] = std::make_shared<const Image>(image);
    resources.material = std::make_shared<const Material>(std::move(material));
    const auto shown
        = [&](std::string_view view, bool linear) { return *drawPicture(renderer, state, 0, resources, view, 8, 8, 1, linear); };
    for (const float exposure : {0.f, 2.f}) {
        state.parameters.exposure = exposure;
        const Image display = shown("color", false), linear = shown("color", true);
        for (int c = 0; c < 3; ++c) {
            const float stored = float(kTexel[c]) / 255.f;
            EXPECT_NEAR(display.value(4, 4, c), stored, 0.6f / 255.f) << exposure;
            EXPECT_NEAR(linear.value(4, 4, c), std::pow((stored + 0.055f) / 1.055f, 2.4f), 0.002f) << exposure;
        }
    }
    for (const ViewRow& view : kViews) { // only light is exposed
        if (view.key.starts_with("error"))
            continue; // flat has none
        state.parameters.exposure = 0.f;
        const Image plain = shown(view.key, false);
        state.parameters.exposure = 2.f;
        EXPECT_EQ(shown(view.key, false).data != plain.data, view.key == "shaded") << view.key;
    }
}

TEST(Views, SamplesSmoothAPenumbra)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = filling("cell-cone");
    Parameters& p = state.parameters;
    p.depth = 0.2f, p.lightSize = 12.f, p.lightPitch = 35.f, p.heightMips = false;
    state.camera.distance = 0.1f; // so near that nothing else differs between neighbours
    Resources resources = resourcesOf(state);
    // Mean difference of a pixel in penumbra from its neighbours.
    const auto grain = [&](int samples) {
        const Image shadow = *drawPicture(renderer, state, 0, resources, "shadow", 128, 128, samples, true);
        double sum = 0.;
        int count = 0;
        for (int y = 1; y < 127; ++y)
            for (int x = 1; x < 127; ++x) {
                const float around[]
                    = {shadow.value(x - 1, y, 0), shadow.value(x + 1, y, 0), shadow.value(x, y - 1, 0), shadow.value(x, y + 1, 0)},
                    here = shadow.value(x, y, 0);
                if (std::ranges::all_of(around, [](float v) { return v > 0.04f && v < 0.96f; }) && here > 0.04f && here < 0.96f)
                    sum += double(std::abs(here - 0.25f * (around[0] + around[1] + around[2] + around[3]))), ++count;
            }
        EXPECT_GT(count, 300);
        return sum / std::max(count, 1);
    };
    const double once = grain(1);
    EXPECT_GT(once, 0.03);
    EXPECT_LT(grain(64), 0.5 * once);
}

// Frames may come from derivatives, which are not defined after pixels were cut out nor in branches.
TEST(Views, FramesAreMadeBeforeAnythingElse)
{
    for (const ViewRow& view : kViews)
        for (const bool onMesh : {false, true})
            for (const Frames frames : {Frames::Vertex, Frames::Derivatives, Frames::Thesis}) {
                ProgramFeatures features;
                features.technique = "cell-cone", features.view = view.key, features.maps = {MapKind::Height};
                features.setVariant(&Parameters::frames, std::size_t(frames)), features.onMesh = onMesh,
                                                                               features.prisms = features.curved = onMesh;
                const auto program = meshProgram(features, embeddedReader());
                ASSERT_TRUE(program) << message(program.error());
                const std::string& text = program->fragment.text;
                const std::size_t main = text.find("void main()");
                const std::string body = text.substr(main, text.find("searched(surface)", main) - main);
                const auto count = [](std::string_view in, std::string_view word) {
                    int found = 0;
                    for (std::size_t at = in.find(word); at != in.npos; at = in.find(word, at + 1))
                        ++found;
                    return found;
                };
                EXPECT_EQ(count(body, "textureFrame()"), 1) << view.key;
                EXPECT_EQ(count(text, "textureFrame()"), 2) << view.key; // and what it is
            }
}
