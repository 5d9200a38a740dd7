// Measuring thickness by rays from each triangle to the other side, and curvature by where moved triangles turn.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/relief_room.h"
#include "core/mesh/edges/places.h"
#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace relievo {

namespace {
constexpr std::size_t kMostAsked = 20'000; // triangles
constexpr double kUsedUp = 0.05; // share of the surface that may be
// Share of its area at which a triangle counts as turned: where it bends both ways alike it turns twice at once.
constexpr double kFlat = 1e-4;
constexpr float kNowhere = std::numeric_limits<float>::infinity();

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;

Scene sceneOf(RTCDevice device, const Mesh& mesh)
{
    Scene scene(rtcNewScene(device), &rtcReleaseScene);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Copied: a buffer that is shared has to be readable a little beyond its end.
    auto* vertices = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    if (vertices && indices) {
        std::ranges::transform(mesh.vertices, vertices, &Vertex::position);
        std::ranges::copy(mesh.indices.begin(), mesh.indices.begin() + std::ptrdiff_t(mesh.indices.size() / 3 * 3), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene.get(), geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    return scene;
}

// A number for each vertex, the same for all that hang together by triangles.
std::vector<std::uint32_t> bodiesOf(const Mesh& mesh)
{
    std::vector<std::uint32_t> body = placesOf(mesh), parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 1; k < 3; ++k)
            parent[root(body[mesh.indices[i]])] = root(body[mesh.indices[i + k]]);
    for (std::uint32_t& number : body)
        number = root(number);
    return body;
}

// m from a triangle's middle along its normal inwards to the back of another of the same body, or infinity.
float thicknessAt(RTCScene scene, const Mesh& mesh, const std::vector<std::uint32_t>& bodies, std::uint32_t own, glm::vec3 middle,
    glm::vec3 inwards, float size)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    float from = 1e-3f * size;
    for (int i = 0; i < 16; ++i) { // through other bodies
        RTCRayHit ray{};
        ray.ray = {middle.x, middle.y, middle.z, from, inwards.x, inwards.y, inwards.z, 0.f, kNowhere, ~0u, 0, 0};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
            return kNowhere;
        if (bodies[mesh.indices[std::size_t(ray.hit.primID) * 3]] == bodies[own])
            return glm::dot(glm::vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z), inwards) > 0.f ? ray.ray.tfar : kNowhere;
        from = std::nextafter(ray.ray.tfar * 1.00001f, kNowhere);
    }
    return kNowhere;
}
} // namespace

float turningDepth(const Vertex& a, const Vertex& b, const Vertex& c)
{
    const glm::dvec3 p = b.position - a.position, q = c.position - a.position;
    const glm::dvec3 dp = a.normal - b.normal, dq = a.normal - c.normal; // for each metre
    const glm::dvec3 up = glm::cross(p, q);
    const double c0 = glm::dot(up, up) * (1. - kFlat), c1 = glm::dot(up, glm::cross(p, dq) + glm::cross(dp, q)),
                 c2 = glm::dot(up, glm::cross(dp, dq));
    const double square = c1 * c1 - 4. * c2 * c0;
    if (square < 0.)
        return kNowhere;
    const double sum = -0.5 * (c1 + (c1 < 0. ? -1. : 1.) * std::sqrt(square));
    double first = double(kNowhere);
    for (const double root : {c0 / sum, sum / c2})
        if (root > 0. && root < first)
            first = root;
    return float(first);
}

float reliefRoom(const Mesh& mesh)
{
    const Device device(rtcNewDevice(nullptr), &rtcReleaseDevice);
    if (!device)
        return kNowhere;
    const Scene scene = sceneOf(device.get(), mesh);
    const std::vector<std::uint32_t> bodies = bodiesOf(mesh);
    struct Place {
        float room; // m
        double area;
    };
    std::vector<Place> places;
    const std::size_t triangles = mesh.indices.size() / 3, step = triangles / kMostAsked + 1;
    double area = 0.;
    for (std::size_t i = 0; i < triangles; i += step) {
        const Vertex &a = mesh.vertices[mesh.indices[3 * i]], &b = mesh.vertices[mesh.indices[3 * i + 1]],
                     &c = mesh.vertices[mesh.indices[3 * i + 2]];
        const glm::vec3 up = glm::cross(b.position - a.position, c.position - a.position);
        const float twice = glm::length(up);
        if (!(twice > 0.f))
            continue;
        const glm::vec3 middle = (a.position + b.position + c.position) / 3.f;
        const float half = 0.5f * thicknessAt(scene.get(), mesh, bodies, mesh.indices[3 * i], middle, up / -twice, std::sqrt(twice));
        places.push_back({std::min(half, turningDepth(a, b, c)), double(twice)});
        area += double(twice);
    }
    std::ranges::sort(places, {}, &Place::room);
    double used = 0.;
    for (const Place& place : places)
        if ((used += place.area) > kUsedUp * area)
            return place.room;
    return kNowhere;
}

} // namespace relievo
