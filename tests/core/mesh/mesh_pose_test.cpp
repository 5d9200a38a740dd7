// Poses of skinned, morphing and moving meshes agree with what their files say, and broken ones stand still.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/pose.h"
#include "core/mesh/frames/frames.h"
#include "core/state/shapes.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/mesh/mesh_support.h"
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
constexpr float kHalf = std::numbers::sqrt2_v<float> / 2.f;

fs::path animated(const std::string& name)
{
    return fs::path(RELIEVO_TEST_DATA) / "meshes/animated" / name;
}

// What a test changes in the strip: everything else is sound.
struct Strip {
    std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0, .5, .5, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    std::vector<std::uint8_t> joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    std::string skinJoints = "[1,2]", path = "rotation", interpolation = "LINEAR", target = "2", extra, targets, nodeExtra;
    std::vector<float> times = {0, 1}, values = {0, 0, 0, 1, 0, 0, kHalf, kHalf};
    std::size_t components = 4;

    // Two quads, one above the other in xy, 2 m high; joint 1 of 2 bends the upper at y = 1. The mesh's own node is moved and scaled.
    std::string file() const
    {
        GltfBuffer buffer;
        const int points = buffer.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 2, 0, 0, 2, 0}, "VEC3", 3);
        const int normals = buffer.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
        const int uvs = buffer.floats({0, 2, 1, 2, 1, 1, 0, 1, 1, 0, 0, 0}, "VEC2", 2);
        const int indices = buffer.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5}, 5121, "SCALAR", 1);
        const int pulls = buffer.floats(weights, "VEC4", 4), pulling = buffer.accessor(joints, 5121, "VEC4", 4);
        const int bind
            = buffer.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}, "MAT4", 16);
        const int input = buffer.floats(times, "SCALAR", 1);
        const int output = buffer.floats(values, components == 4 ? "VEC4" : components == 3 ? "VEC3" : "SCALAR", components);
        const int lift = buffer.floats({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0}, "VEC3", 3);
        const auto number = [](int n) { return std::to_string(n); };
        std::string morph = targets;
        if (const std::size_t at = morph.find('#'); at != morph.npos)
            morph.replace(at, 1, number(lift));
        return buffer.file("\"scenes\":[{\"nodes\":[0,3]}],\"nodes\":[{\"children\":[1],\"translation\":[0,0,3]},{\"children\":[2]},{"
                           "\"translation\":[0,1,0]},"
                           "{\"mesh\":0,\"translation\":[5,0,0],\"scale\":[2,2,2]"
            + nodeExtra + "}],\"skins\":[{\"joints\":" + skinJoints + ",\"inverseBindMatrices\":" + number(bind)
            + "}],\"meshes\":[{\"primitives\":[{\"indices\":" + number(indices) + morph + ",\"attributes\":{\"POSITION\":" + number(points)
            + ",\"NORMAL\":" + number(normals) + ",\"TEXCOORD_0\":" + number(uvs) + extra + ",\"JOINTS_0\":" + number(pulling)
            + ",\"WEIGHTS_0\":" + number(pulls) + "}}]}],\"animations\":[{\"name\":\"bend\",\"samplers\":[{\"input\":" + number(input)
            + ",\"output\":" + number(output) + ",\"interpolation\":\"" + interpolation
            + "\"}],\"channels\":[{\"sampler\":0,\"target\":{\"node\":" + target + ",\"path\":\"" + path + "\"}}]}],");
    }
};

const std::string kSkin = ",\"skin\":0";

// Where the file puts the point `local` of weight w on joint 1, when joint 1 is turned by `degrees` about z.
glm::vec3 bent(glm::vec3 local, float w, float degrees)
{
    const glm::mat4 root = glm::translate(glm::mat4(1.f), {0.f, 0.f, 3.f}), up = glm::translate(glm::mat4(1.f), {0.f, 1.f, 0.f});
    const glm::mat4 joint = root * up * glm::rotate(glm::mat4(1.f), glm::radians(degrees), {0.f, 0.f, 1.f}) * glm::inverse(up);
    return (1.f - w) * glm::vec3(root * glm::vec4(local, 1.f)) + w * glm::vec3(joint * glm::vec4(local, 1.f));
}

// The point of the file that a vertex of the mesh was.
glm::vec3 localOf(const Vertex& v)
{
    return (v.position - glm::vec3(5.f, 0.f, 0.f)) / 2.f;
}

float angleAt(const Mesh& mesh, float seconds)
{
    const Pose pose = poseAt(mesh, 0, seconds);
    const glm::vec3 right = glm::mat3(pose.joints.back()) * glm::vec3(2.f, 0.f, 0.f);
    return glm::degrees(std::atan2(right.y, right.x));
}

// Height of the root, which a translation animates.
float heightAt(const Mesh& mesh, float seconds)
{
    return poseAt(mesh, 0, seconds).joints.back()[3].y;
}

Mesh strip(const Strip& parts)
{
    Expected<Mesh> mesh = opened("a.gltf", parts.file());
    EXPECT_TRUE(mesh) << message(mesh.error());
    return mesh.value_or(Mesh{});
}

Strip skinned()
{
    Strip parts;
    parts.nodeExtra = kSkin;
    return parts;
}

// The mesh's own node climbs along y.
Strip climbing(const std::string& interpolation, std::vector<float> times, std::vector<float> values)
{
    Strip parts;
    parts.target = "3";
    parts.path = "translation";
    parts.interpolation = interpolation;
    parts.times = std::move(times);
    parts.values = std::move(values);
    parts.components = 3;
    return parts;
}
} // namespace

TEST(MeshPose, MeshesThatDoNotMoveHaveNoDeformation)
{
    for (const std::string_view shape : kShapes)
        EXPECT_EQ(openMesh(std::string(shape))->deformation != nullptr, shape == "character") << shape;
    const Mesh mesh = *openMesh("box");
    EXPECT_TRUE(bindPose(mesh).joints.empty());
    EXPECT_TRUE(poseAt(mesh, 0, 1.f).joints.empty());
    EXPECT_EQ(posed(mesh, {}).vertices.size(), mesh.vertices.size());
}

TEST(MeshPose, SkinnedVerticesGoWhereTheFileSays)
{
    const Mesh mesh = strip(skinned());
    ASSERT_TRUE(mesh.deformation);
    ASSERT_EQ(mesh.deformation->clips.size(), 1u);
    EXPECT_EQ(mesh.deformation->clips[0].name, "bend");
    EXPECT_EQ(mesh.deformation->clips[0].seconds, 1.f);
    for (const auto& [seconds, degrees] :
        {std::pair(0.f, 0.f), std::pair(0.5f, 45.f), std::pair(1.f, 90.f), std::pair(7.f, 90.f), std::pair(-1.f, 0.f)}) {
        const Mesh moved = posed(mesh, poseAt(mesh, 0, seconds));
        expectSound(moved);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const glm::vec3 local = localOf(mesh.vertices[i]);
            EXPECT_LT(glm::distance(moved.vertices[i].position, bent(local, local.y / 2.f, degrees)), 1e-5f);
            EXPECT_NEAR(moved.vertices[i].normal.z, 1.f, 1e-5f);
        }
    }
}

TEST(MeshPose, JacobiansAreThoseOfTheMovedTriangles)
{
    const Mesh mesh = strip(skinned());
    const Mesh moved = posed(mesh, poseAt(mesh, 0, 1.f));
    Mesh fresh = moved;
    completeFrames(fresh);
    ASSERT_EQ(fresh.vertices.size(), moved.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_LT(glm::distance(moved.vertices[i].dPdu, fresh.vertices[i].dPdu), 1e-5f);
        EXPECT_LT(glm::distance(moved.vertices[i].dPdv, fresh.vertices[i].dPdv), 1e-5f);
        EXPECT_GT(
            glm::distance(moved.vertices[i].dPdu, mesh.vertices[i].dPdu), 0.5f); // half the size at least: the node's scale does not count
        EXPECT_EQ(moved.vertices[i].tangent.w, 1.f);
    }
    EXPECT_EQ(moved.metresPerUV, mesh.metresPerUV);
    EXPECT_EQ(moved.boundsMin, fresh.boundsMin);
    EXPECT_EQ(moved.boundsMax, fresh.boundsMax);
}

TEST(MeshPose, BindPoseIsTheMesh)
{
    const Mesh mesh = strip(skinned());
    const Mesh same = posed(mesh, bindPose(mesh));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_LT(glm::distance(same.vertices[i].position, mesh.vertices[i].position), 1e-6f);
        EXPECT_LT(glm::distance(same.vertices[i].dPdu, mesh.vertices[i].dPdu), 1e-5f);
        EXPECT_LT(glm::distance(same.vertices[i].tangent, mesh.vertices[i].tangent), 1e-5f);
    }
    EXPECT_EQ(poseAt(mesh, -1, 0.f).joints.size(), mesh.deformation->joints.size());
    EXPECT_EQ(poseAt(mesh, 99, 0.f).joints.size(), mesh.deformation->joints.size());
    EXPECT_TRUE(std::isfinite(angleAt(mesh, std::nanf(""))));
}

TEST(MeshPose, InterpolationsAndKeys)
{
    const Mesh linear = strip(climbing("LINEAR", {0, 1, 3}, {5, 0, 0, 5, 1, 0, 5, 5, 0}));
    EXPECT_NEAR(heightAt(linear, 0.25f), 0.25f, 1e-5f);
    EXPECT_NEAR(heightAt(linear, 2.f), 3.f, 1e-5f);
    const Mesh step = strip(climbing("STEP", {0, 1, 3}, {5, 0, 0, 5, 1, 0, 5, 5, 0}));
    EXPECT_NEAR(heightAt(step, 0.99f), 0.f, 1e-5f);
    EXPECT_NEAR(heightAt(step, 2.99f), 1.f, 1e-5f);
    EXPECT_NEAR(heightAt(step, 3.f), 5.f, 1e-5f);
    // From 0 to 1 in 2 s, leaving at 3 m/s and arriving at -1 m/s: Hermite's basis at the middle is 1/2, 1/8, 1/2, -1/8.
    const Mesh cubic = strip(climbing("CUBICSPLINE", {0, 2}, {0, 9, 0, 5, 0, 0, 0, 3, 0, 0, -1, 0, 5, 1, 0, 0, 9, 0}));
    EXPECT_NEAR(heightAt(cubic, 1.f), 0.5f + 2.f * (3.f / 8.f + 1.f / 8.f), 1e-5f);
    EXPECT_NEAR(heightAt(cubic, 2.f), 1.f, 1e-5f);
    const Mesh one = strip(climbing("LINEAR", {1}, {5, 4, 0}));
    for (const float seconds : {-1.f, 0.f, 1.f, 9.f})
        EXPECT_NEAR(heightAt(one, seconds), 4.f, 1e-5f);
    const Mesh unsorted = strip(climbing("LINEAR", {3, 0, 1}, {5, 5, 0, 5, 0, 0, 5, 1, 0}));
    EXPECT_TRUE(told(unsorted, "animation-times"));
    EXPECT_NEAR(heightAt(unsorted, 2.f), 3.f, 1e-5f);
}

TEST(MeshPose, RotationsTakeTheShortWay)
{
    Strip parts = skinned();
    parts.values = {0, 0, 0, 1, 0, 0, -kHalf, -kHalf}; // the same turn as 90 degrees
    EXPECT_NEAR(angleAt(strip(parts), 0.5f), 45.f, 1e-3f);
}

TEST(MeshPose, NodesThatMoveCarryTheirMesh)
{
    Strip parts = climbing("LINEAR", {0, 1}, {5, 0, 0, 5, 2, 0});
    const Mesh mesh = strip(parts);
    const Mesh moved = posed(mesh, poseAt(mesh, 0, 1.f));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        EXPECT_LT(glm::distance(moved.vertices[i].position, mesh.vertices[i].position + glm::vec3(0.f, 2.f, 0.f)), 1e-5f);
}

TEST(MeshPose, BrokenSkinsStandStillAndAreTold)
{
    Strip missing = skinned();
    missing.skinJoints = "[1,77]";
    const Mesh partly = strip(missing);
    EXPECT_TRUE(told(partly, "skin-joints"));
    expectSound(posed(partly, poseAt(partly, 0, 1.f)));
    Strip few = skinned();
    few.skinJoints = "[1]"; // the vertices name joint 1, which is not there
    const Mesh less = strip(few);
    EXPECT_TRUE(told(less, "skin-joints"));
    expectSound(posed(less, poseAt(less, 0, 1.f)));
    Strip odd = skinned();
    for (float& weight : odd.weights)
        weight *= 3.f;
    const Mesh scaled = strip(odd);
    EXPECT_TRUE(told(scaled, "skin-weights"));
    const Mesh right = strip(skinned());
    for (std::size_t i = 0; i < right.vertices.size(); ++i)
        EXPECT_LT(glm::distance(
                      posed(scaled, poseAt(scaled, 0, 1.f)).vertices[i].position, posed(right, poseAt(right, 0, 1.f)).vertices[i].position),
            1e-5f);
    Strip none = skinned();
    std::ranges::fill(none.weights, 0.f);
    const Mesh loose = strip(none);
    EXPECT_TRUE(told(loose, "skin-weights"));
    expectSound(posed(loose, poseAt(loose, 0, 1.f)));
}

TEST(MeshPose, StrongestFourOfManyInfluencesCount)
{
    Strip parts = skinned();
    // A second set with the same joints: eight influences, of which the four strongest are twice 0.5 and twice 0.4 of joint 1.
    for (std::size_t i = 0; i < 24; ++i) {
        parts.joints[i] = i % 4 == 0 ? 0 : 1;
        parts.weights[i] = i % 4 == 0 ? 0.05f : 0.5f;
    }
    parts.extra = ",\"JOINTS_1\":5,\"WEIGHTS_1\":4"; // the accessors of the first set
    const Mesh mesh = strip(parts);
    EXPECT_TRUE(told(mesh, "skin-influences"));
    for (const Influence& influence : mesh.deformation->influences) {
        float sum = 0.f;
        for (std::size_t k = 0; k < 4; ++k) {
            sum += influence.weights[k];
            EXPECT_EQ(influence.joints[k], influence.joints[0]); // joint 1 only
        }
        EXPECT_NEAR(sum, 1.f, 1e-5f);
    }
}

TEST(MeshPose, BrokenChannelsAreLeftOutAndTold)
{
    Strip counts = skinned();
    counts.times = {0, 1, 2}; // but two values
    Strip path = skinned();
    path.path = "colour";
    Strip node = skinned();
    node.target = "44";
    Strip interpolation = skinned();
    interpolation.interpolation = "BEZIER";
    Strip numbers = skinned();
    numbers.values[3] = std::nanf("");
    for (const Strip& parts : {counts, path, node, interpolation, numbers}) {
        const Mesh mesh = strip(parts);
        EXPECT_TRUE(told(mesh, "animation-channels"));
        EXPECT_EQ(mesh.deformation, nullptr); // nothing is left that moves
    }
}

TEST(MeshPose, MorphTargetsAddPositionsAndFrames)
{
    Strip parts = climbing("LINEAR", {0, 2}, {0, 1});
    parts.path = "weights";
    parts.components = 1;
    parts.targets = ",\"targets\":[{\"POSITION\":#}]";
    const Mesh mesh = strip(parts);
    ASSERT_TRUE(mesh.deformation);
    ASSERT_EQ(mesh.deformation->targets.size(), 1u);
    const Pose half = poseAt(mesh, 0, 1.f), whole = poseAt(mesh, 0, 2.f);
    EXPECT_NEAR(half.weights.at(0), 0.5f, 1e-6f);
    const Mesh moved = posed(mesh, whole), between = posed(mesh, half);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const MorphDelta& delta = mesh.deformation->targets[0].deltas[i];
        const glm::vec3 lift = localOf(mesh.vertices[i]).y > 1.5f ? glm::vec3(2.f, 2.f, 0.f) : glm::vec3(0.f); // in the scaled node
        EXPECT_LT(glm::distance(moved.vertices[i].position, mesh.vertices[i].position + lift), 1e-5f);
        EXPECT_LT(glm::distance(between.vertices[i].position, mesh.vertices[i].position + 0.5f * lift), 1e-5f);
        EXPECT_LT(glm::distance(moved.vertices[i].dPdu, mesh.vertices[i].dPdu + delta.dPdu), 1e-5f);
        EXPECT_LT(glm::distance(moved.vertices[i].dPdv, mesh.vertices[i].dPdv + delta.dPdv), 1e-5f);
        EXPECT_LT(glm::distance(moved.vertices[i].normal, mesh.vertices[i].normal + delta.normal), 1e-5f);
    }
}

TEST(MeshPose, MutatedFilesMoveSoundly)
{
    Strip morphing = skinned();
    morphing.targets = ",\"targets\":[{\"POSITION\":#}]";
    std::mt19937 random(5);
    const int rounds = fuzzRounds(200);
    const Scratch scratch;
    for (const std::string& seed : {skinned().file(), morphing.file()})
        for (int round = 0; round < rounds; ++round) {
            const Expected<Mesh> mesh = openMesh(scratch.write("a.gltf", mutated(seed, random)));
            if (!mesh) {
                expectSentence(mesh.error(), "a.gltf");
                continue;
            }
            expectSound(posed(*mesh, poseAt(*mesh, 0, 0.7f)));
            ASSERT_FALSE(HasFailure()) << "round " << round;
        }
}

TEST(MeshPose, RealFilesMoveSoundly)
{
    for (const char* name : {"AnimatedMorphCube.glb", "CesiumMan.glb", "RiggedSimple.glb", "SimpleMorph.gltf"}) {
        if (!fs::exists(animated(name)))
            GTEST_SKIP() << "no test data at " << animated(name);
        SCOPED_TRACE(name);
        const Expected<Mesh> mesh = openMesh(animated(name).string());
        ASSERT_TRUE(mesh) << message(mesh.error());
        ASSERT_TRUE(mesh->deformation);
        ASSERT_EQ(mesh->deformation->clips.size(), 1u);
        const float seconds = mesh->deformation->clips[0].seconds;
        EXPECT_GT(seconds, 0.5f);
        const Mesh same = posed(*mesh, bindPose(*mesh));
        for (std::size_t i = 0; i < mesh->vertices.size(); ++i)
            ASSERT_LT(glm::distance(same.vertices[i].position, mesh->vertices[i].position), 1e-5f);
        float travelled = 0.f;
        for (int step = 0; step <= 8; ++step) {
            const Mesh moved = posed(*mesh, poseAt(*mesh, 0, seconds * float(step) / 8.f));
            expectSound(moved);
            const glm::vec3 was = mesh->boundsMax - mesh->boundsMin, is = moved.boundsMax - moved.boundsMin;
            EXPECT_LT(std::max({is.x, is.y, is.z}), 3.f * std::max({was.x, was.y, was.z}));
            for (std::size_t i = 0; i < mesh->vertices.size(); ++i)
                travelled = std::max(travelled, glm::distance(moved.vertices[i].position, mesh->vertices[i].position));
        }
        EXPECT_GT(travelled, 0.01f);
    }
}

// The walking man stands upright, and no pose of his tears him: edges keep about their length.
TEST(MeshPose, WalkingManKeepsHisShape)
{
    if (!fs::exists(animated("CesiumMan.glb")))
        GTEST_SKIP() << "no test data at " << animated("CesiumMan.glb");
    const Mesh mesh = *openMesh(animated("CesiumMan.glb").string());
    const Mesh moved = posed(mesh, poseAt(mesh, 0, 0.7f));
    double before = 0, change = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1];
        const double was = double(glm::distance(mesh.vertices[a].position, mesh.vertices[b].position));
        before += was;
        change += std::abs(double(glm::distance(moved.vertices[a].position, moved.vertices[b].position)) - was);
    }
    EXPECT_LT(change / before, 0.1);
    EXPECT_GT(moved.boundsMax.y - moved.boundsMin.y, 1.f);
}
