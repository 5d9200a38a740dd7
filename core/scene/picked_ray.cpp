// The eye's ray against the mesh, and the search ray there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/picked_ray.h"
#include "core/mesh/frames/push.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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

std::optional<Crossing> firstOf(const Mesh& mesh, double pushOut, dvec3 eye, dvec3 way)
{
    const std::vector<glm::vec3> push = pushOut != 0. ? pushDirections(mesh) : std::vector<glm::vec3>();
    const auto place = [&](std::size_t i) {
        const std::uint32_t vertex = mesh.indices[i];
        return dvec3(mesh.vertices[vertex].position) + (push.empty() ? dvec3(0.) : pushOut * dvec3(push[vertex]));
    };
    std::optional<Crossing> first;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        if (auto hit = crossing(eye, way, place(i), place(i + 1), place(i + 2)); hit && (!first || hit->distance < first->distance)) {
            first = hit;
            first->index = i;
        }
    return first;
}

// As frameOf and rayInto in shaders/surface/surface.glsl.
SearchRay searchRay(dvec3 normal, dvec3 alongU, dvec3 alongV, dvec2 uv, dvec3 toEye, double depth)
{
    const double area = dot(normal, cross(alongU, alongV)), inverse = std::abs(area) > 1e-20 ? 1. / area : 0.;
    const double cosine = std::clamp(dot(normal, toEye), 0.002, 1.);
    const dvec3 travel = toEye * (-depth / cosine);
    return {uv, {dot(travel, cross(alongV, normal)) * inverse, dot(travel, cross(normal, alongU)) * inverse}, cosine};
}
} // namespace

std::optional<PickedRay> pickedRay(const State& state, std::size_t pane, const Resources& resources, glm::vec2 at, float aspect)
{
    const Parameters parameters = effectiveParameters(state, pane);
    const TechniqueRow* technique = findTechnique(state.panes[pane].technique);
    const CameraView view = cameraOnto(*resources.mesh, cameraOf(state, pane), aspect);
    const SceneUniforms scene = sceneUniforms(parameters, view, resources.mesh->metresPerUV);
    std::optional<Mesh> moved;
    if (resources.mesh->deformation)
        moved = posed(*resources.mesh, poseOf(*resources.mesh, parameters));
    const Mesh& mesh = moved ? *moved : *resources.mesh;
    const glm::vec4 beyond
        = glm::inverse(view.clipFromView * view.viewFromWorld) * glm::vec4(2.f * at.x - 1.f, 1.f - 2.f * at.y, 0.5f, 1.f);
    const dvec3 eye(view.eye), way = normalize(dvec3(beyond) / double(beyond.w) - eye);
    const double pushOut = technique && technique->displaces ? double((1.f - parameters.midlevel) * scene.reliefDepth) : 0.;
    const auto hit = firstOf(mesh, pushOut, eye, way);
    if (!hit)
        return std::nullopt;
    const Vertex *corners[3], &first = mesh.vertices[mesh.indices[hit->index]];
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = &mesh.vertices[mesh.indices[hit->index + i]];
    const auto between = [&](auto Vertex::*member) {
        using Exact = std::conditional_t<std::is_same_v<decltype(first.*member), const glm::vec2&>, dvec2, dvec3>;
        const double weights[3] = {1. - hit->b - hit->c, hit->b, hit->c};
        Exact sum(0.);
        for (int i = 0; i < 3; ++i)
            sum += weights[i] * Exact(corners[i]->*member);
        return sum;
    };
    const auto part = std::ranges::find_if(
        mesh.parts, [&](const MeshPart& p) { return hit->index >= p.firstIndex && hit->index < std::size_t(p.firstIndex) + p.indexCount; });
    const std::vector<char> plain = plainParts(*resources.mesh, state.part);
    const double relief = part == mesh.parts.end() ? 1. : plain[std::size_t(part - mesh.parts.begin())] ? 0. : double(part->relief);
    const dvec3 normal = normalize(between(&Vertex::normal)) * (hit->isFront ? 1. : -1.);
    const glm::dmat2 turn(scene.textureFromMesh), back(scene.meshFromTexture);
    const dvec3 u = between(&Vertex::dPdu), v = between(&Vertex::dPdv);
    const dvec2 uv = turn * between(&Vertex::uv) + dvec2(scene.textureShift);
    return PickedRay{
        searchRay(normal, u * back[0][0] + v * back[0][1], u * back[1][0] + v * back[1][1], uv, -way, relief * double(scene.reliefDepth)),
        relief == 0., parameters.silhouettes != Silhouettes::Off};
}

} // namespace relievo
