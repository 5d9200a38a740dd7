// Colours, normals and roughness of an object's sides against what the mesh is there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "core/object/bake/dilate.h"
#include "core/object/bake/side_pictures.h"
#include "core/object/object_search.h"
#include "tests/core/mesh/mesh_support.h"
#include "tests/core/object/object_meshes.h"

using namespace relievo;
using namespace relievo::test;

namespace {
AxisPictures pictured(const Mesh& mesh, std::size_t axis, const ObjectOptions& options)
{
    const auto surface = MeshSurface::load(mesh, {});
    EXPECT_TRUE(surface && surface->warnings().empty());
    const auto box = boxOf(mesh);
    EXPECT_TRUE(box);
    auto pictures = bakePictures(*surface, *box, axis, options);
    EXPECT_TRUE(pictures);
    return pictures.value_or(AxisPictures());
}

glm::vec3 rgb(const Image& image, int x, int y)
{
    return {image.value(x, y, 0), image.value(x, y, 1), image.value(x, y, 2)};
}

// A picture of two halves, left and right.
std::string halves(const Scratch& scratch, const std::string& name, glm::vec3 left, glm::vec3 right)
{
    Image image{16, 4, 3, PixelType::U8, 8, false, std::vector<std::byte>(16 * 4 * 3)};
    for (int i = 0; i < 64; ++i)
        for (int c = 0; c < 3; ++c)
            image.data[std::size_t(3 * i + c)] = std::byte(std::lround(255.f * (i % 16 < 8 ? left : right)[c]));
    const std::string file = (scratch.path / name).string();
    EXPECT_TRUE(writeImage(file, image, true));
    return file;
}

// Facing +z, u to the right and v down, of one material.
Mesh card(const MapSlots& maps)
{
    Mesh mesh = meshOf(quad({-1.f, -1.f, 0.f}, {1.f, -1.f, 0.f}, {1.f, 1.f, 0.f}, {-1.f, 1.f, 0.f}));
    for (Vertex& vertex : mesh.vertices)
        vertex.uv = {0.5f + 0.5f * vertex.position.x, 0.5f - 0.5f * vertex.position.y};
    mesh.parts[0].material = "paint";
    mesh.materials = {{"paint", maps}};
    return mesh;
}
} // namespace

TEST(SidePictures, NormalsOfASphereFaceOutOfEachSide)
{
    const auto sphere = makeShape("sphere");
    ASSERT_TRUE(sphere);
    constexpr int size = 64;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisPictures pictures = pictured(*sphere, axis, {ObjectSides::Six, 1, size, 2});
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double u = (2. * x + 1.) / size - 1., v = (2. * y + 1.) / size - 1., rest = 1. - u * u - v * v;
                const float alpha = pictures.front.color.value(x, y, 3);
                EXPECT_FALSE(rest < -0.1 && alpha > 0.f);
                if (rest < 0.15)
                    continue;
                EXPECT_EQ(alpha, 1.f);
                const glm::vec3 exact(u, -v, std::sqrt(rest));
                EXPECT_LT(glm::length(2.f * rgb(pictures.front.normal, x, y) - 1.f - exact), 0.03f);
                EXPECT_LT(glm::length(2.f * rgb(pictures.back.normal, x, y) - 1.f - exact), 0.03f);
                EXPECT_EQ(pictures.front.roughness.value(x, y, 0), 1.f);
            }
    }
}

TEST(SidePictures, EmptyTexelsGoOnFromTheirNeighbours)
{
    const auto sphere = makeShape("sphere");
    ASSERT_TRUE(sphere);
    const AxisPictures pictures = pictured(*sphere, 2, {ObjectSides::Six, 1, 48, 1});
    const float told = pictures.front.color.value(24, 24, 0);
    EXPECT_GT(told, 0.5f); // kColorWithoutMap as sRGB
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(pictures.front.color.value(x, y, c), told, 1e-4f) << x << ' ' << y;
    std::vector<glm::vec4> values(5 * 3, glm::vec4(0.f));
    std::vector<float> filled(15, 0.f);
    values[7] = {1.f, 2.f, 3.f, 4.f};
    filled[7] = 0.25f;
    dilate(values, filled, 5, 3);
    for (const glm::vec4& value : values)
        EXPECT_EQ(value, glm::vec4(1.f, 2.f, 3.f, 4.f));
}

// Both sides lie on the same texels.
TEST(SidePictures, ColoursLieWhereTheMeshHasThem)
{
    const Scratch scratch;
    MapSlots maps;
    maps[std::size_t(MapKind::Color)].file = halves(scratch, "color.png", {1.f, 0.f, 0.f}, {0.f, 0.5f, 0.f});
    maps[std::size_t(MapKind::Roughness)].file = halves(scratch, "roughness.png", glm::vec3(0.2f), glm::vec3(0.8f));
    const AxisPictures pictures = pictured(card(maps), 2, {ObjectSides::Two, 1, 16, 3});
    for (const SidePictures* side : {&pictures.front, &pictures.back}) {
        EXPECT_LT(glm::length(rgb(side->color, 4, 8) - glm::vec3(1.f, 0.f, 0.f)), 0.01f);
        EXPECT_LT(glm::length(rgb(side->color, 12, 8) - glm::vec3(0.f, 0.5f, 0.f)), 0.01f);
        EXPECT_NEAR(side->roughness.value(4, 8, 0), 0.2f, 0.01f);
        EXPECT_NEAR(side->roughness.value(12, 8, 0), 0.8f, 0.01f);
        EXPECT_NEAR(side->normal.value(8, 8, 2), 1.f, 1e-4f); // out of each side
    }
}

TEST(SidePictures, WhatOpacityCutsIsNotThere)
{
    const Scratch scratch;
    MapSlots maps;
    maps[std::size_t(MapKind::Opacity)].file = halves(scratch, "opacity.png", glm::vec3(1.f), glm::vec3(0.f));
    const Mesh mesh = card(maps);
    const AxisPictures pictures = pictured(mesh, 2, {ObjectSides::Six, 1, 32, 2});
    EXPECT_EQ(pictures.front.color.value(10, 16, 3), 1.f);
    EXPECT_EQ(pictures.front.color.value(24, 16, 3), 0.f);
    for (const ObjectSides sides : {ObjectSides::One, ObjectSides::Two, ObjectSides::Six}) {
        const BakedDepths baked = bakedDepths(mesh, {sides, 1, 32, 2});
        EXPECT_TRUE(firstHit(baked.object, {-0.5, 0.1, 3.}, {0.05, 0., -1.}));
        EXPECT_FALSE(firstHit(baked.object, {0.5, 0.1, 3.}, {0.05, 0., -1.}));
        EXPECT_FALSE(isTold(baked.warnings, "open-mesh")); // leaves are meant to be open
    }
}

// A normal map that leans to the image's right, on a card: red grows, on both sides of the card.
TEST(SidePictures, NormalMapsAreKept)
{
    const Scratch scratch;
    MapSlots maps;
    maps[std::size_t(MapKind::Normal)].file = halves(scratch, "normal.png", {0.9f, 0.5f, 0.8f}, {0.5f, 0.9f, 0.8f});
    const AxisPictures pictures = pictured(card(maps), 2, {ObjectSides::Two, 1, 16, 1});
    const glm::vec3 right = glm::normalize(glm::vec3(0.8f, 0.f, 0.6f)), up = glm::normalize(glm::vec3(0.f, 0.8f, 0.6f));
    EXPECT_LT(glm::length(2.f * rgb(pictures.front.normal, 4, 8) - 1.f - right), 0.02f);
    EXPECT_LT(glm::length(2.f * rgb(pictures.front.normal, 12, 8) - 1.f - up), 0.02f);
}
