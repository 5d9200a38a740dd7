// Bilinear reads of a material's maps at interpolated UVs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/mesh_surface.h"
#include "core/ground/srgb.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {

namespace {
// Decoded once: a power for each texel read would take longer than everything else.
const std::vector<float>& linearTable(PixelType type)
{
    static const auto make = [](std::size_t count) {
        std::vector<float> table(count);
        for (std::size_t i = 0; i < count; ++i)
            table[i] = linearOf(float(i) / float(count - 1));
        return table;
    };
    static const std::vector<float> bytes = make(256), words = make(65536);
    return type == PixelType::U8 ? bytes : words;
}

float linearAt(const Image& image, int x, int y, int channel)
{
    const float value = image.value(x, y, channel);
    if (image.type == PixelType::F32)
        return value;
    const std::vector<float>& table = linearTable(image.type);
    return table[std::size_t(std::lround(value * float(table.size() - 1)))];
}

// Bilinear between texel centres; the image repeats, or goes on as at its border.
template <class Texel> glm::vec3 bilinear(const Image& image, glm::vec2 uv, bool clamped, Texel texel)
{
    const Wrap wrap = clamped ? Wrap::Clamp : Wrap::Repeat;
    const float x = uv.x * float(image.width) - 0.5f, y = uv.y * float(image.height) - 0.5f;
    if (!(std::abs(x) < 1e9f && std::abs(y) < 1e9f))
        return texel(0, 0);
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const float fx = x - float(x0), fy = y - float(y0);
    const int left = wrapIndex(x0, image.width, wrap), right = wrapIndex(x0 + 1, image.width, wrap);
    const int top = wrapIndex(y0, image.height, wrap), bottom = wrapIndex(y0 + 1, image.height, wrap);
    return (texel(left, top) * (1.f - fx) + texel(right, top) * fx) * (1.f - fy)
        + (texel(left, bottom) * (1.f - fx) + texel(right, bottom) * fx) * fy;
}

float valueAt(const Image& image, glm::vec2 uv, bool clamped)
{
    return bilinear(image, uv, clamped, [&](int x, int y) { return glm::vec3(image.value(x, y, 0)); }).x;
}

template <class Member> auto mixed(const Mesh& mesh, std::size_t triangle, glm::dvec3 weights, Member member)
{
    const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[3 * triangle + k]].*member; };
    return corner(0) * float(weights.x) + corner(1) * float(weights.y) + corner(2) * float(weights.z);
}
} // namespace

MeshSurface::Look MeshSurface::lookOf(const MeshMaterial& material, Warnings& warnings, const Progress& progress)
{
    Look look;
    look.isPlain = !material.factors;
    look.factors = material.factors.value_or(MeshFactors());
    MapSlots wanted;
    for (const MapKind kind : {MapKind::Color, MapKind::Normal, MapKind::Roughness, MapKind::Gloss, MapKind::Opacity})
        wanted[std::size_t(kind)] = material.maps[std::size_t(kind)];
    const auto read = loadMaterial(wanted, {}, nullptr, Progress{{}, progress.stop});
    if (!read) {
        if (!isCancelled(read.error()))
            warnings.push_back({"map-broken", message(read.error())});
        return look;
    }
    warnings.insert(warnings.end(), read->warnings.begin(), read->warnings.end());
    const auto map = [&](MapKind kind) { return read->maps[std::size_t(kind)]; };
    look.color = map(MapKind::Color);
    look.normal = map(MapKind::Normal);
    look.roughness = map(MapKind::Roughness);
    look.gloss = map(MapKind::Gloss);
    look.opacity = map(MapKind::Opacity);
    return look;
}

Expected<MeshSurface> MeshSurface::load(const Mesh& mesh, const Progress& progress)
{
    MeshSurface surface;
    surface.m_mesh = &mesh;
    surface.m_looks.emplace_back(); // of parts whose material the file does not describe
    for (const MeshMaterial& material : mesh.materials) {
        if (progress.cancelled())
            return cancelled(mesh.name);
        surface.m_looks.push_back(lookOf(material, surface.m_warnings, progress));
        progress.at(float(surface.m_looks.size() - 1) / float(mesh.materials.size()));
    }
    if (mesh.materials.empty() || mesh.materials.size() >= 65535)
        return surface;
    surface.m_lookOfTriangle.resize(mesh.indices.size() / 3, 0);
    for (const MeshPart& part : mesh.parts) {
        const auto found = std::ranges::find(mesh.materials, part.material, &MeshMaterial::name);
        if (found == mesh.materials.end())
            continue;
        const auto first = surface.m_lookOfTriangle.begin() + std::ptrdiff_t(part.firstIndex / 3);
        std::fill_n(first, part.indexCount / 3, std::uint16_t(found - mesh.materials.begin() + 1));
    }
    return surface;
}

glm::vec2 MeshSurface::uvAt(std::size_t triangle, glm::dvec3 weights) const
{
    return mixed(*m_mesh, triangle, weights, &Vertex::uv);
}

bool MeshSurface::isOpaque(std::size_t triangle, glm::dvec3 weights) const
{
    const Look& look = lookOf(triangle);
    return !look.opacity || valueAt(*look.opacity, uvAt(triangle, weights), look.factors.clamped) >= kOpaque;
}

SurfacePoint MeshSurface::at(std::size_t triangle, glm::dvec3 weights) const
{
    const Look& look = lookOf(triangle);
    const bool clamped = look.factors.clamped;
    const glm::vec2 uv = uvAt(triangle, weights);
    SurfacePoint point;
    point.color = look.color ? look.factors.color
            * bilinear(*look.color, uv, clamped,
                [&](int x, int y) {
                    const Image& image = *look.color;
                    return glm::vec3(linearAt(image, x, y, 0), linearAt(image, x, y, 1), linearAt(image, x, y, 2));
                })
        : look.isPlain ? glm::vec3(kColorWithoutMap)
                       : look.factors.color;
    const glm::vec3 normal = glm::normalize(mixed(*m_mesh, triangle, weights, &Vertex::normal));
    point.normal = normal;
    if (look.normal) {
        const glm::vec4 tangent = mixed(*m_mesh, triangle, weights, &Vertex::tangent);
        const glm::vec3 along = glm::normalize(glm::vec3(tangent)), up = glm::cross(normal, along) * (tangent.w < 0.f ? -1.f : 1.f);
        const glm::vec3 read = 2.f * bilinear(*look.normal, uv, clamped, [&](int x, int y) {
            const Image& image = *look.normal;
            return glm::vec3(image.value(x, y, 0), image.value(x, y, 1), image.value(x, y, 2));
        }) - 1.f;
        point.normal = glm::normalize(look.factors.normal * (read.x * along + read.y * up) + read.z * normal);
    }
    const float smooth = look.roughness ? valueAt(*look.roughness, uv, clamped)
        : look.gloss                    ? 1.f - valueAt(*look.gloss, uv, clamped)
                                        : 1.f;
    point.roughness = look.factors.roughness * smooth;
    if (!(glm::dot(point.normal, point.normal) > 0.5f)) // opposite normals that cancel
        point.normal = {0.f, 0.f, 1.f};
    return point;
}

} // namespace relievo
