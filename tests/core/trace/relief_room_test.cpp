// How deep a relief fits, on bodies whose thickness is known.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/shapes.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include "core/trace/relief_room.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace relievo;

TEST(ReliefRoom, IsHalfTheThicknessOrTheRadius)
{
    EXPECT_NEAR(reliefRoom(*makeShape("sphere")), 0.5f, 0.005f); // its radius
    const Mesh torus = *makeShape("torus");
    EXPECT_NEAR(reliefRoom(torus), 0.5f * (torus.boundsMax.y - torus.boundsMin.y), 0.002f); // of its tube
    EXPECT_NEAR(reliefRoom(*makeShape("box")), 0.5f, 1e-4f);
    EXPECT_TRUE(std::isinf(reliefRoom(*makeShape("plane"))));
    EXPECT_GT(reliefRoom(*makeShape("spheres")), 0.05f); // the plane below them is no other side
    EXPECT_TRUE(std::isinf(reliefRoom(Mesh())));
}

// A thin plate: two sheets back to back.
TEST(ReliefRoom, APlateIsAsThickAsItsSheetsAreApart)
{
    Mesh plate = *makeShape("plane");
    const auto vertices = std::uint32_t(plate.vertices.size()), indices = std::uint32_t(plate.indices.size());
    for (std::uint32_t i = 0; i < vertices; ++i) {
        Vertex below = plate.vertices[i];
        below.position.y -= 0.1f, below.normal = -below.normal;
        plate.vertices.push_back(below);
    }
    for (std::uint32_t i = 0; i < indices; i += 3)
        for (const std::uint32_t k : {0u, 2u, 1u})
            plate.indices.push_back(plate.indices[i + k] + vertices);
    for (const std::uint32_t side : {0u, 1u}) // one body
        plate.indices.insert(plate.indices.end(), {0, vertices + side, vertices});
    EXPECT_NEAR(reliefRoom(plate), 0.05f, 1e-4f);
}

TEST(ReliefRoom, WhatFitsIsTold)
{
    State state = openSource("sample:cobblestones@16", State())->state;
    state.mesh = "torus", state.panes = {Pane{"relief", {}}};
    Resources resources = *loadResources(state, {}, {});
    const float fits = fittingDepth(state.parameters, resources.mesh->metresPerUV, resources.fit);
    const float lowest = *std::min_element(resources.material->height->texels().begin(), resources.material->height->texels().end());
    EXPECT_NEAR(fits * resources.mesh->metresPerUV * (1.f - lowest), reliefRoom(*resources.mesh), 1e-4f);
    state.parameters.depth = 0.99f * fits;
    EXPECT_FALSE(tooDeep(state, resources));
    state.parameters.depth = 1.01f * fits;
    const auto warning = tooDeep(state, resources);
    ASSERT_TRUE(warning);
    EXPECT_EQ(warning->code, "relief-too-deep");
    state.parameters.tiling = 2.f; // half as deep
    EXPECT_FALSE(tooDeep(state, resources));
    state.parameters.tiling = 1.f, state.panes = {Pane{"bump", {}}}; // nothing is displaced
    EXPECT_FALSE(tooDeep(state, resources));
}
