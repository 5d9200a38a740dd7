// Relief objects against the mesh that they were baked from, from all around: how much of the picture is wrong, and how long baking takes.
// object_bench [--bake|--searches] [MESH...]; without meshes the built-in torus, askew, teapot and knight. --bake: only the time and memory
// of baking a torus of a million triangles to six sides of 1024 x 1024. --searches: what each technique finds of a million rays, and reads.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/shapes.h"
#include "core/object/bake/side_pictures.h"
#include "core/object/object_search.h"
#include "core/object/object_shader.h"
#include "core/state/techniques.h"
#include "tests/core/object/object_support.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <embree3/rtcore.h>
#include <numbers>
#include <oneapi/tbb/parallel_for.h>
#include <string>
#include <sys/resource.h>

using namespace relievo;

namespace {
constexpr int kDirections = 24, kPixels = 96; // pictures from around, and rays along each of their sides
constexpr double kOff = 0.01; // of the mesh's diameter: a depth that differs by more is another surface

// Points evenly about a sphere.
glm::dvec3 directionOf(int i)
{
    const double z = 1. - 2. * (i + 0.5) / kDirections, around = i * std::numbers::pi * (3. - std::sqrt(5.)), r = std::sqrt(1. - z * z);
    return {r * std::cos(around), r * std::sin(around), z};
}

RTCScene sceneOf(RTCDevice device, const Mesh& mesh)
{
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    std::ranges::transform(mesh.vertices, vertices, &Vertex::position);
    std::ranges::copy(mesh.indices, indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

struct Differences {
    std::size_t seen = 0, outline = 0, other = 0; // rays that meet either; only one of the two; another surface
    double square = 0.; // of the others' depths, shares of the diameter
    void operator+=(const Differences& more)
    {
        seen += more.seen;
        outline += more.outline;
        other += more.other;
        square += more.square;
    }
};

// One picture, parallel rays.
Differences compared(const ReliefObject& object, RTCScene scene, glm::dvec3 direction)
{
    const double radius = glm::length(glm::dvec3(object.half[0].x, object.half[1].y, object.half[2].z));
    const glm::dvec3 u
        = glm::normalize(glm::cross(direction, std::abs(direction.y) < 0.9 ? glm::dvec3(0., 1., 0.) : glm::dvec3(1., 0., 0.)));
    const glm::dvec3 v = glm::cross(direction, u);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    Differences found;
    for (int i = 0; i < kPixels * kPixels; ++i) {
        const auto at = [&](int k) { return radius * (2. * (k + 0.5) / kPixels - 1.); };
        const glm::vec3 from = object.center + at(i % kPixels) * u + at(i / kPixels) * v - 2. * radius * direction, along = direction;
        RTCRayHit ray{};
        ray.ray = {from.x, from.y, from.z, 0.f, along.x, along.y, along.z, 0.f, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &ray);
        const bool isMet = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        const auto hit = firstHit(object, from, along);
        found.seen += isMet || hit;
        found.outline += isMet != bool(hit);
        if (!isMet || !hit)
            continue;
        const double off = (hit->t - double(ray.ray.tfar)) / (2. * radius);
        if (std::abs(off) > kOff)
            ++found.other;
        else
            found.square += off * off;
    }
    return found;
}

int refuse(const Error& error)
{
    std::fprintf(stderr, "%s\n", message(error).c_str());
    return 1;
}

// What a technique has found of many rays.
struct Searched {
    std::size_t wrong = 0, ties = 0, fetches = 0;
    void operator+=(const Searched& more) { wrong += more.wrong, ties += more.ties, fetches += more.fetches; }
};

// Against the search in double precision on the same maps. The exact technique is wrong where it is off by a ten thousandth of the box and
// no ray beside it agrees; the others, where they are off by kOff or find something where there is nothing.
int searchAll(const Mesh& mesh)
{
    constexpr int kBatches = 1000, kRays = 1000;
    const auto surface = MeshSurface::load(mesh, {});
    if (!surface)
        return refuse(surface.error());
    for (const int layers : {1, 2, 4}) {
        const auto baked = bakeDepths(*surface, {ObjectSides::Six, layers, 512, 2});
        if (!baked)
            return refuse(baked.error());
        const ReliefObject& object = baked->object;
        const ObjectTexels texels = objectTexels(object);
        const double size = glm::length(object.half[0] + object.half[1] + object.half[2]), least = test::leastSize(object);
        std::array<std::array<Searched, kObjectTechniques.size()>, kBatches> batches;
        oneapi::tbb::parallel_for(0, kBatches, [&](int batch) {
            std::mt19937 random{unsigned(batch)};
            for (int i = 0; i < kRays; ++i) {
                const glm::dvec3 to = object.center + 0.5 * size * test::evenDirection(random),
                                 from = object.center + (i % 8 == 0 ? 0.3 : 3.) * size * test::evenDirection(random),
                                 way = glm::normalize(to - from);
                const auto exact = firstHit(object, from, way);
                for (std::size_t k = 0; k < kObjectTechniques.size(); ++k) {
                    const TechniqueRow& row = kObjectTechniques[k];
                    const ObjectRayHit found = searchObject(row.key, {}, object, texels, from, way);
                    const double off = row.isExact ? 1e-4 * least : kOff * 2. * size;
                    const bool isRight = bool(exact) == found.found && (!exact || std::abs(exact->t - found.t) <= off);
                    const bool isTie = !isRight && row.isExact && test::isTie(object, found, from, way);
                    batches[std::size_t(batch)][k] += {!isRight && !isTie, isTie, std::size_t(found.fetches)};
                }
            }
        });
        for (std::size_t k = 0; k < kObjectTechniques.size(); ++k) {
            Searched all;
            for (const auto& batch : batches)
                all += batch[k];
            std::printf("| %s | %d | %s | %zu | %zu | %.1f |\n", mesh.name.c_str(), layers, kObjectTechniques[k].key.data(), all.wrong,
                all.ties, double(all.fetches) / (kBatches * kRays));
        }
        std::fflush(stdout);
    }
    return 0;
}

int compareAll(const Mesh& mesh, RTCDevice device)
{
    const auto surface = MeshSurface::load(mesh, {});
    if (!surface)
        return refuse(surface.error());
    RTCScene scene = sceneOf(device, mesh);
    for (const ObjectSides sides : {ObjectSides::One, ObjectSides::Two, ObjectSides::Six})
        for (const int layers : {1, 2, 4})
            for (const int size : {128, 256, 512}) {
                if (sides == ObjectSides::One && layers > 1)
                    continue; // one front is one layer
                const auto baked = bakeDepths(*surface, {sides, layers, size, 2});
                if (!baked)
                    return refuse(baked.error());
                std::array<Differences, kDirections> each;
                oneapi::tbb::parallel_for(
                    0, kDirections, [&](int i) { each[std::size_t(i)] = compared(baked->object, scene, directionOf(i)); });
                Differences all;
                for (const Differences& one : each)
                    all += one;
                const auto seen = double(all.seen), right = seen - double(all.outline + all.other);
                std::printf("| %s | %d | %d | %d | %.2f | %.2f | %.3f |\n", mesh.name.c_str(), int(sides), layers, size,
                    100. * double(all.outline) / seen, 100. * double(all.other) / seen, 100. * std::sqrt(all.square / std::max(right, 1.)));
                std::fflush(stdout);
            }
    rtcReleaseScene(scene);
    return 0;
}

// Turned so that no axis of its box looks through it.
Mesh askew(Mesh mesh)
{
    const glm::dvec3 y = glm::normalize(glm::dvec3(1., 1.1, 0.9)), x = glm::normalize(glm::cross(y, glm::dvec3(1., 0., 0.)));
    const glm::dmat3 turn(x, y, glm::cross(x, y));
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = turn * glm::dvec3(vertex.position);
        vertex.normal = turn * glm::dvec3(vertex.normal);
    }
    mesh.name += " askew";
    return mesh;
}

Mesh fineTorus()
{
    constexpr std::uint32_t around = 1000, across = 500;
    Mesh mesh;
    mesh.name = "fine torus";
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const double a = 2. * std::numbers::pi * i / around, b = 2. * std::numbers::pi * j / across;
            const glm::dvec3 out(std::cos(a), 0., -std::sin(a)), normal = std::cos(b) * out + glm::dvec3(0., std::sin(b), 0.);
            mesh.vertices.push_back({0.35 * out + 0.15 * normal, normal, {a, b}, {-std::sin(a), 0.f, -std::cos(a), 1.f}, {}, {}});
            const auto at = [&](std::uint32_t k, std::uint32_t l) { return (i + k) % around * across + (j + l) % across; };
            for (const std::uint32_t index : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)})
                mesh.indices.push_back(index);
        }
    mesh.parts = {{"", "", 0, std::uint32_t(mesh.indices.size()), 1.f}};
    return askew(std::move(mesh));
}

long peakMiB()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss >> 10;
}

int timeBake()
{
    const Mesh mesh = fineTorus();
    const auto surface = MeshSurface::load(mesh, {});
    for (const int layers : {1, 2}) {
        const ObjectOptions options{ObjectSides::Six, layers, 1024, 2};
        const long before = peakMiB();
        const auto start = std::chrono::steady_clock::now();
        const auto since = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
        const auto baked = bakeDepths(*surface, options);
        if (!baked)
            return refuse(baked.error());
        const double depths = since();
        std::vector<AxisPictures> pictures;
        for (std::size_t axis = 0; axis < 3; ++axis)
            pictures.push_back(*bakePictures(*surface, *boxOf(mesh), axis, options));
        std::size_t bytes = 0;
        for (const AxisPictures& axis : pictures)
            for (const SidePictures* side : {&axis.front, &axis.back})
                bytes += side->color.data.size() + side->normal.data.size() + side->roughness.data.size();
        for (const AxisMap& map : baked->object.axes)
            bytes += map.intervals.size() * sizeof(Interval);
        std::printf("%zu triangles, 6 sides, 1024 x 1024, %d layers: depths %.2f s, all maps %.2f s; maps %zu MiB, peak grew by %ld MiB\n",
            mesh.indices.size() / 3, layers, depths, since(), bytes >> 20, peakMiB() - before);
    }
    return 0;
}
} // namespace

int main(int argc, char** argv)
{
    if (argc > 1 && std::string(argv[1]) == "--bake")
        return timeBake();
    const bool searches = argc > 1 && std::string(argv[1]) == "--searches";
    const int first = searches ? 2 : 1;
    RTCDevice device = rtcNewDevice(nullptr);
    std::printf(searches ? "| mesh | layers | technique | wrong of 1 million | ties | fetches a ray |\n|---|---|---|---|---|---|\n"
                         : "| mesh | sides | layers | size | outline wrong %% | another surface %% | depth RMSE, %% of the diameter "
                           "|\n|---|---|---|---|---|---|---|\n");
    const auto all = [&](const Mesh& mesh) { return searches ? searchAll(mesh) : compareAll(mesh, device); };
    int result = 0;
    if (argc == first)
        for (const Mesh& mesh : {askew(*makeShape("torus")), *makeShape("teapot"), *makeShape("knight")})
            result += all(mesh);
    for (int i = first; i < argc && result == 0; ++i) {
        const auto mesh = openMesh(argv[i]);
        result = mesh ? all(*mesh) : refuse(mesh.error());
    }
    rtcReleaseDevice(device);
    return result;
}
