// Relief objects written to files and read again, also where files are missing or odd.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/object_files.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/object/object_file.h"
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
