// Relief objects written to files and read again, also where files are missing or odd.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/object_files.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/object/object_file.h"
#include "core/object/object_looks.h"
#include "core/object/object_sides.h"
#include "tests/core/mesh/mesh_support.h"
#include "tests/core/object/object_meshes.h"
#include <nlohmann/json.hpp>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
// Two boxes behind each other.
Mesh boxes()
{
    Mesh mesh = meshOf(boxCorners({0.f, 0.f, 0.f}, {1.f, 1.f, 0.3f}) + boxCorners({0.f, 0.f, 0.6f}, {0.5f, 2.f, 1.f}));
    mesh.name = "boxes";
    return mesh;
}

fs::path written(const Scratch& scratch, const Mesh& mesh, const ObjectOptions& options)
{
    const auto surface = MeshSurface::load(mesh, {});
    EXPECT_TRUE(surface);
    const auto exported = writeObject({&*surface, options, scratch.path / "out", "", {}});
    EXPECT_TRUE(exported) << (exported ? "" : message(exported.error()));
    return exported ? exported->files.back() : fs::path();
}

nlohmann::json jsonOf(const fs::path& file)
{
    return nlohmann::json::parse(*readText(file));
}
void put(const fs::path& file, const nlohmann::json& value)
{
    ASSERT_TRUE(writeAtomically(file, value.dump()));
}
} // namespace

TEST(ObjectFile, WhatIsWrittenIsReadAgain)
{
    for (const ObjectSides sides : {ObjectSides::One, ObjectSides::Two, ObjectSides::Six})
        for (const int layers : {1, 2, 4}) {
            const Scratch scratch;
            const Mesh mesh = boxes();
            const ObjectOptions options{sides, layers, 12, 2};
            const auto read = readObject(written(scratch, mesh, options));
            ASSERT_TRUE(read) << message(read.error());
            EXPECT_EQ(read->object, bakedDepths(mesh, options).object) << int(sides) << ' ' << layers;
            EXPECT_TRUE(read->warnings.empty());
        }
}

TEST(ObjectFile, EverySideHasItsPicturesOf16Bits)
{
    const Scratch scratch;
    const fs::path file = written(scratch, boxes(), {ObjectSides::Six, 2, 8, 1});
    EXPECT_EQ(file.filename(), "boxes.object.json");
    std::size_t depths = 0, others = 0;
    const nlohmann::json document = jsonOf(file);
    for (const auto& map : document["maps"]) {
        const auto info = readImageInfo(file.parent_path() / map["file"].get<std::string>());
        ASSERT_TRUE(info);
        EXPECT_EQ(info->storedBits, 16);
        EXPECT_EQ(info->width, 8);
        (map["kind"] == "depth" ? depths : others) += 1;
    }
    EXPECT_EQ(depths, 12u);
    EXPECT_EQ(others, 18u);
}

TEST(ObjectFile, AMissingSideIsToldByItsName)
{
    const Scratch scratch;
    const fs::path file = written(scratch, boxes(), {ObjectSides::Six, 1, 8, 1});
    nlohmann::json document = jsonOf(file), kept = nlohmann::json::array();
    for (const auto& map : document["maps"])
        if (map["side"] != "-x")
            kept.push_back(map);
    document["maps"] = kept;
    put(file, document);
    const auto read = readObject(file);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "side-missing");
    EXPECT_NE(read->warnings[0].text.find("-x"), std::string::npos);
    EXPECT_EQ(read->object.axes[0].at(1, 6, 0).back, Interval::kDeepest);
}

TEST(ObjectFile, SidesOfAnAxisThatDifferInSizeAreRefused)
{
    const Scratch scratch;
    const fs::path file = written(scratch, boxes(), {ObjectSides::Six, 1, 8, 1});
    const Image other{4, 8, 1, PixelType::U16, 16, false, std::vector<std::byte>(64)};
    ASSERT_TRUE(writeImage(file.parent_path() / "boxes_NegY_Depth.png", other));
    const auto read = readObject(file);
    ASSERT_FALSE(read);
    EXPECT_NE(message(read.error()).find("boxes_NegY_Depth.png"), std::string::npos);
    EXPECT_NE(message(read.error()).find("boxes_PosY_Depth.png"), std::string::npos);
}

TEST(ObjectFile, WhatIsNoObjectIsRefused)
{
    const Scratch scratch;
    const fs::path file = written(scratch, boxes(), {ObjectSides::Two, 1, 1, 1}); // of one texel
    ASSERT_TRUE(readObject(file));
    const nlohmann::json sound = jsonOf(file);
    for (const char* text : {"", "[]", "{}", "{\"relievoObject\":1}", "{\"relievoObject\":1,\"box\":3,\"maps\":7}"}) {
        ASSERT_TRUE(writeAtomically(file, std::string_view(text)));
        EXPECT_FALSE(readObject(file)) << text;
    }
    nlohmann::json odd = sound;
    odd["box"]["halfAxes"][1] = {0, 0, 0};
    put(file, odd);
    EXPECT_FALSE(readObject(file));
    odd = sound;
    odd["maps"]
        = nlohmann::json::array({1, "x", nullptr, {{"side", 3}}, {{"kind", "depth"}, {"side", "+q"}, {"file", "a.png"}, {"layer", 1}}});
    put(file, odd);
    EXPECT_FALSE(readObject(file));
    odd = sound;
    odd["maps"][0]["file"] = "gone.png";
    put(file, odd);
    EXPECT_FALSE(readObject(file));
    EXPECT_FALSE(readObject(scratch.path / "nothing.object.json"));
}

// Depths by hand, of 8 bits, with a back before its front.
TEST(ObjectFile, ABackBeforeItsFrontIsEmptyAndTold)
{
    const Scratch scratch;
    const fs::path file = written(scratch, boxes(), {ObjectSides::Two, 1, 2, 1});
    const auto grey = [&](const char* name, std::vector<int> values) {
        Image image{2, 2, 1, PixelType::U8, 8, false, {}};
        for (const int value : values)
            image.data.push_back(std::byte(value));
        EXPECT_TRUE(writeImage(file.parent_path() / name, image));
    };
    grey("boxes_PosZ_Depth.png", {0, 128, 200, 255});
    grey("boxes_NegZ_Depth.png", {0, 100, 200, 255});
    const auto read = readObject(file);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "back-before-front");
    const AxisMap& map = read->object.axes[2];
    EXPECT_TRUE(map.at(0, 0, 0).isSolid());
    EXPECT_TRUE(map.at(1, 0, 0).isSolid());
    EXPECT_FALSE(map.at(0, 1, 0).isSolid());
    EXPECT_EQ(map.at(1, 1, 0), Interval());
}

TEST(ObjectFile, AFailureLeavesNothingBehind)
{
    const Scratch scratch;
    const Mesh mesh = boxes();
    const auto surface = MeshSurface::load(mesh, {});
    ASSERT_TRUE(surface);
    std::stop_source stop;
    const Progress late{[&](float share) {
                            if (share > 0.6f)
                                stop.request_stop();
                        },
        stop.get_token()};
    const auto stopped = writeObject({&*surface, {ObjectSides::Six, 1, 16, 1}, scratch.path / "out", {}, late});
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
    EXPECT_FALSE(fs::exists(scratch.path / "out"));
}

// The papers' packing: both depths are told from the side's face, and 1 is nothing.
TEST(ObjectFile, PackedPicturesHoldBothDepthsAndNormals)
{
    const Scratch scratch;
    Image packed{2, 1, 4, PixelType::U8, 8, false, {}};
    for (const int value : {255, 128, 204, 51, 128, 128, 255, 255}) // a normal along u, back 0.8, front 0.2; then nothing
        packed.data.push_back(std::byte(value));
    ASSERT_TRUE(writeImage(scratch.path / "dual.png", packed));
    const fs::path file = scratch.path / "dual.object.json";
    nlohmann::json object{{"relievoObject", 1}, {"sides", 2},
        {"box", {{"center", {0, 0, 0}}, {"halfAxes", {{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.1}}}}},
        {"maps", {{{"side", "+z"}, {"kind", "packed"}, {"file", "dual.png"}}}}};
    put(file, object);
    const auto maps = readObjectMaps(file);
    ASSERT_TRUE(maps) << message(maps.error());
    EXPECT_TRUE(maps->warnings.empty());
    const AxisMap& map = maps->object.axes[2];
    EXPECT_EQ(map.at(0, 0, 0), (Interval{13107, 52428}));
    EXPECT_FALSE(map.at(1, 0, 0).isSolid());
    EXPECT_FALSE(maps->object.axes[0].isGiven());
    ASSERT_TRUE(maps->looks[4].normal && maps->looks[5].normal); // the second made of the depths
    EXPECT_GT(maps->looks[4].normal->value(0, 0, 0), 0.95f);
    EXPECT_NEAR(maps->looks[4].normal->value(1, 0, 2), 1.f, 1e-3f);
    EXPECT_NEAR(maps->looks[5].normal->value(0, 0, 2), 1.f, 2e-3f); // of a sheet that ends beside it
    EXPECT_FALSE(maps->looks[4].color);

    object["maps"] = {{{"side", "+z"}, {"kind", "depth"}, {"file", "dual.png"}, {"convention", "height"}}};
    object["sides"] = 1;
    put(file, object);
    const auto heights = readObjectMaps(file);
    ASSERT_TRUE(heights) << message(heights.error());
    EXPECT_EQ(heights->object.axes[2].at(0, 0, 0).front, 0); // white is near
    EXPECT_EQ(heights->object.axes[2].at(1, 0, 0).front, 65535 - 128 * 257);
}

// A plane that is tilted by 45 degrees along u, on a box that is not a cube, from both its sides.
TEST(ObjectFile, NormalsThatNoPictureBringsAreThoseOfTheDepths)
{
    ReliefObject object;
    object.half = {glm::dvec3(1., 0., 0.), glm::dvec3(0., 0.5, 0.), glm::dvec3(0., 0., 2.)};
    object.axes[2] = {8, 4, 1, {}};
    for (int i = 0; i < 32; ++i) {
        const double depth = (i % 8 + 0.5) / 8. * 2. / 4.; // 2 m along u, 4 m deep
        object.axes[2].intervals.push_back({std::uint16_t(depth * 65535.), std::uint16_t((depth + 0.25) * 65535.)});
    }
    const Image front = normalsOfDepths(object, 2, false), back = normalsOfDepths(object, 2, true);
    const double half = std::sqrt(0.5);
    for (int i = 0; i < 32; ++i) {
        EXPECT_NEAR(2. * double(front.value(i % 8, i / 8, 0)) - 1., half, 1e-3);
        EXPECT_NEAR(2. * double(front.value(i % 8, i / 8, 1)) - 1., 0., 1e-3);
        EXPECT_NEAR(2. * double(front.value(i % 8, i / 8, 2)) - 1., half, 1e-3);
        EXPECT_NEAR(2. * double(back.value(i % 8, i / 8, 0)) - 1., -half, 1e-3);
    }
}
