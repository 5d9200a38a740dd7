// Cobblestones on a mesh, and how far two pictures of it are apart.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/source.h"
#include "render/windowless.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace relievo::test {

inline const std::filesystem::path kMeshes = std::filesystem::path(RELIEVO_TEST_DATA) / "meshes";

inline State stateOn(const std::string& mesh, const char* technique = "cell-cone")
{
    State state = openSource("sample:cobblestones@256", State())->state;
    state.mesh = mesh;
    state.panes = {Pane{technique, {}}};
    return state;
}

inline Resources resourcesOf(const State& state)
{
    auto resources = loadResources(state, {}, {});
    EXPECT_TRUE(resources) << (resources ? "" : message(resources.error()));
    return resources.value_or(Resources());
}

inline Image picture(Renderer& renderer, const State& state, Resources resources, std::string_view view, int width = 160, int height = 120)
{
    State plain = state;
    plain.parameters.background = Backdrop::Transparent;
    const auto image = drawPicture(renderer, plain, 0, resources, view, width, height, 1, true);
    EXPECT_TRUE(image) << (image ? "" : message(image.error()));
    return image.value_or(Image());
}

// Share of the pixels, of those that either picture covers, whose coverage differs or whose values differ by more than `tolerance`.
inline double differing(const Image& a, const Image& b, float tolerance)
{
    double pixels = 0., differ = 0.;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const bool inA = a.value(x, y, 3) > 0.5f, inB = b.value(x, y, 3) > 0.5f;
            pixels += inA || inB;
            float off = 0.f;
            for (int c = 0; c < 3; ++c)
                off = std::max(off, std::abs(a.value(x, y, c) - b.value(x, y, c)));
            differ += inA != inB || (inA && !(off <= tolerance));
        }
    EXPECT_GT(pixels, 500.);
    return differ / std::max(pixels, 1.);
}

} // namespace relievo::test
