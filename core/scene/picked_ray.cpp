// The eye's ray against the mesh, and the search ray there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/picked_ray.h"
#include "core/mesh/frames/push.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace relievo {
namespace {
using glm::dvec2;
using glm::dvec3;

struct Crossing {
    double distance;
    double b, c; // weights of the second and third corner
    std::size_t index; // of the triangle's first corner in Mesh::indices
    bool isFront;
};

// Moeller and Trumbore 1997, Fast, Minimum Storage Ray/Triangle Intersection.
std::optional<Crossing> crossing(dvec3 eye, dvec3 way, dvec3 p0, dvec3 p1, dvec3 p2)
{
    const dvec3 e1 = p1 - p0, e2 = p2 - p0, p = cross(way, e2);
    const double area = dot(e1, p);
    if (std::abs(area) < 1e-300)
        return std::nullopt;
    const dvec3 s = eye - p0, q = cross(s, e1);
    const double b = dot(s, p) / area, c = dot(way, q) / area, distance = dot(e2, q) / area;
    if (b < 0. || c < 0. || b + c > 1. || !(distance > 0.))
        return std::nullopt;
    return Crossing{distance, b, c, 0, area > 0.};
}

// As frameOf and rayInto in shaders/surface/surface.glsl.
SearchRay searchRay(dvec3 normal, dvec3 alongU, dvec3 alongV, dvec2 uv, dvec3 toEye, double depth)
{
    const double area = dot(normal, cross(alongU, alongV)), inverse = std::abs(area) > 1e-20 ? 1. / area : 0.;
    const double cosine = std::clamp(dot(normal, toEye), 0.002, 1.);
    const dvec3 travel = toEye * (-depth / cosine);
    return {uv, {dot(travel, cross(alongV, normal)) * inverse, dot(travel, cross(normal, alongU)) * inverse}, cosine};
}

// A pane's picture and the mesh in it, as its technique draws it.
class Picture {
public:
    Picture(const State& state, std::size_t pane, const Resources& resources, float aspect)
        : m_parameters(effectiveParameters(state, pane))
        , m_view(cameraOnto(*resources.mesh, cameraOf(state, pane), aspect))
        , m_scene(sceneUniforms(m_parameters, m_view, resources.mesh->metresPerUV))
        , m_clipFromWorld(m_view.clipFromView * m_view.viewFromWorld)
        , m_worldFromClip(glm::inverse(m_clipFromWorld))
        , m_plain(plainParts(*resources.mesh, state.part))
    {
        if (resources.mesh->deformation)
            m_moved = posed(*resources.mesh, poseOf(*resources.mesh, m_parameters));
        m_mesh = m_moved ? &*m_moved : resources.mesh.get();
        const TechniqueRow* technique = findTechnique(state.panes[pane].technique);
        m_pushOut = technique && technique->displaces ? double((1.f - m_parameters.midlevel) * m_scene.reliefDepth) : 0.;
        if (m_pushOut != 0.)
            m_push = pushDirections(*m_mesh);
    }
    Picture(const Picture&) = delete; // m_mesh may lie in it

    std::size_t corners() const { return m_mesh->indices.size() / 3 * 3; }
    dvec3 eye() const { return dvec3(m_view.eye); }
    dvec3 place(std::size_t corner) const
    {
        const std::uint32_t vertex = m_mesh->indices[corner];
        return dvec3(m_mesh->vertices[vertex].position) + (m_push.empty() ? dvec3(0.) : m_pushOut * dvec3(m_push[vertex]));
    }
    dvec3 wayTo(glm::vec2 at) const // unit
    {
        const glm::vec4 beyond = m_worldFromClip * glm::vec4(2.f * at.x - 1.f, 1.f - 2.f * at.y, 0.5f, 1.f);
        return normalize(dvec3(beyond) / double(beyond.w) - eye());
    }
    std::optional<dvec2> seenAt(dvec3 place) const // share of the picture; nothing behind the eye
    {
        const glm::dvec4 clip = glm::dmat4(m_clipFromWorld) * glm::dvec4(place, 1.);
        return clip.w > 1e-9 ? std::optional(dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w)) : std::nullopt;
    }
    PickedRay ray(const Crossing& hit, dvec3 way) const;

private:
    Parameters m_parameters;
    CameraView m_view;
    SceneUniforms m_scene;
    glm::mat4 m_clipFromWorld, m_worldFromClip;
    std::vector<char> m_plain; // by part
    std::optional<Mesh> m_moved;
    const Mesh* m_mesh;
    double m_pushOut = 0.;
    std::vector<glm::vec3> m_push;
};

PickedRay Picture::ray(const Crossing& hit, dvec3 way) const
{
    const Vertex *corners[3], &first = m_mesh->vertices[m_mesh->indices[hit.index]];
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = &m_mesh->vertices[m_mesh->indices[hit.index + i]];
    const auto between = [&](auto Vertex::*member) {
        using Exact = std::conditional_t<std::is_same_v<decltype(first.*member), const glm::vec2&>, dvec2, dvec3>;
        const double weights[3] = {1. - hit.b - hit.c, hit.b, hit.c};
        Exact sum(0.);
        for (int i = 0; i < 3; ++i)
            sum += weights[i] * Exact(corners[i]->*member);
        return sum;
    };
    const auto part = std::ranges::find_if(m_mesh->parts,
        [&](const MeshPart& p) { return hit.index >= p.firstIndex && hit.index < std::size_t(p.firstIndex) + p.indexCount; });
    const double relief = part == m_mesh->parts.end() ? 1. : m_plain[std::size_t(part - m_mesh->parts.begin())] ? 0. : double(part->relief);
    const dvec3 normal = normalize(between(&Vertex::normal)) * (hit.isFront ? 1. : -1.);
    const glm::dmat2 turn(m_scene.textureFromMesh), back(m_scene.meshFromTexture);
    const dvec3 u = between(&Vertex::dPdu), v = between(&Vertex::dPdv);
    const dvec2 uv = turn * between(&Vertex::uv) + dvec2(m_scene.textureShift);
    const double depth = relief * double(m_scene.reliefDepth);
    return {searchRay(normal, u * back[0][0] + v * back[0][1], u * back[1][0] + v * back[1][1], uv, -way, depth), depth, hit.distance,
        relief == 0., m_parameters.silhouettes != Silhouettes::Off};
}

void keepNearer(std::optional<Crossing>& first, const std::optional<Crossing>& hit, std::size_t index)
{
    if (hit && (!first || hit->distance < first->distance)) {
        first = hit;
        first->index = index;
    }
}
} // namespace

std::optional<PickedRay> pickedRay(const State& state, std::size_t pane, const Resources& resources, glm::vec2 at, float aspect)
{
    const Picture picture(state, pane, resources, aspect);
    const dvec3 way = picture.wayTo(at);
    std::optional<Crossing> first;
    for (std::size_t i = 0; i < picture.corners(); i += 3)
        keepNearer(first, crossing(picture.eye(), way, picture.place(i), picture.place(i + 1), picture.place(i + 2)), i);
    return first ? std::optional(picture.ray(*first, way)) : std::nullopt;
}

std::vector<std::optional<PickedRay>> pickedRays(
    const State& state, std::size_t pane, const Resources& resources, glm::ivec2 grid, float aspect, const Progress& progress)
{
    const Picture picture(state, pane, resources, aspect);
    const std::size_t count = std::size_t(grid.x) * std::size_t(grid.y);
    std::vector<dvec3> ways;
    for (int y = 0; y < grid.y; ++y)
        for (int x = 0; x < grid.x; ++x)
            ways.push_back(picture.wayTo((glm::vec2(x, y) + 0.5f) / glm::vec2(grid)));
    std::vector<std::optional<Crossing>> first(count);
    for (std::size_t i = 0; i < picture.corners(); i += 3) {
        if (i % 30000 == 0 && progress.cancelled())
            return {};
        const dvec3 corners[3] = {picture.place(i), picture.place(i + 1), picture.place(i + 2)};
        dvec2 low(1e9), high(-1e9); // of the pixels that it may cover
        for (const dvec3& corner : corners) {
            const auto seen = picture.seenAt(corner); // one behind the eye: it may cover any
            low = min(low, seen ? *seen : dvec2(-1e9)), high = max(high, seen ? *seen : dvec2(1e9));
        }
        const glm::ivec2 from = clamp(floor(low * dvec2(grid) - 0.51), dvec2(0.), dvec2(grid));
        const glm::ivec2 to = clamp(ceil(high * dvec2(grid) + 0.51), dvec2(0.), dvec2(grid));
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x) {
                const std::size_t pixel = std::size_t(y) * std::size_t(grid.x) + std::size_t(x);
                keepNearer(first[pixel], crossing(picture.eye(), ways[pixel], corners[0], corners[1], corners[2]), i);
            }
    }
    std::vector<std::optional<PickedRay>> rays(count);
    for (std::size_t pixel = 0; pixel < count; ++pixel)
        if (first[pixel])
            rays[pixel] = picture.ray(*first[pixel], ways[pixel]);
    return rays;
}

} // namespace relievo
