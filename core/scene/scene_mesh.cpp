// Meshes by their readers, objects as the boxes that they are drawn in.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_mesh.h"
#include "core/ground/name_forms.h"
#include "core/mesh/readers/raw_mesh.h"
#include "core/mesh/shapes/shapes.h"
#include "core/object/bake/side_pictures.h"
#include "core/object/object_file.h"
#include "core/state/state.h"

namespace relievo {

Expected<Mesh> boxMesh(const ReliefObject& object, const std::string& name)
{
    RawMesh raw;
    raw.name = name;
    raw.uvs = {{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {-1., 1.}) {
            const AxisFrame& frame = kAxisFrames[axis];
            const auto world = [&](glm::dvec3 inBox) {
                return object.center + object.half[0] * inBox.x + object.half[1] * inBox.y + object.half[2] * inBox.z;
            };
            const auto first = std::uint32_t(raw.positions.size());
            // Seen from outside counter-clockwise: u x v = depth, so u before v from behind the back, and v before u from before the front.
            for (const glm::dvec2 at : {glm::dvec2(-1., -1.), glm::dvec2(1., -1.), glm::dvec2(1., 1.), glm::dvec2(-1., 1.)})
                raw.addPosition(world(frame.u * at.x + frame.v * at.y + frame.depth * side));
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
                const std::uint32_t turned = side > 0. ? corner : (4 - corner) % 4;
                raw.corners.push_back({.position = first + turned, .uv = turned});
            }
        }
    raw.parts.push_back({"box", "", 0, std::uint32_t(raw.corners.size())});
    return buildMesh(std::move(raw), name, {});
}

namespace {
Expected<ObjectMaps> bakedShape(const std::string& name, std::string_view shape, const Progress& progress)
{
    const std::optional<Mesh> mesh = makeShape(shape);
    const auto surface = MeshSurface::load(*mesh, progress.part(0.f, 0.1f));
    if (!surface)
        return tl::unexpected(surface.error());
    ObjectOptions options{.size = 256};
    options.sides = name.ends_with("@1") ? ObjectSides::One : name.ends_with("@2") ? ObjectSides::Two : ObjectSides::Six;
    options.layers = options.sides == ObjectSides::Six ? 2 : 1;
    auto baked = bakeDepths(*surface, options, progress.part(0.1f, 0.4f));
    if (!baked)
        return tl::unexpected(baked.error());
    ObjectMaps maps{std::move(baked->object), {}, {}, std::string(shape), {}};
    maps.texels = objectTexels(maps.object);
    const auto given = axesOf(options.sides);
    for (std::size_t axis = 0; axis < given.size(); ++axis) {
        if (!given[axis])
            continue;
        auto pictures
            = bakePictures(*surface, baked->box, axis, options, progress.part(0.4f + 0.2f * float(axis), 0.6f + 0.2f * float(axis)));
        if (!pictures)
            return tl::unexpected(pictures.error());
        for (auto [side, look] : {std::pair(2 * axis, &pictures->front), std::pair(2 * axis + 1, &pictures->back)})
            maps.looks[side] = {std::move(look->color), std::move(look->normal), std::move(look->roughness)};
    }
    if (options.sides == ObjectSides::One) // what lies behind is not seen from there
        maps.looks[5] = {};
    completeLooks(maps);
    return maps;
}
} // namespace

Expected<Mesh> openSceneMesh(const std::string& nameOrFile, const Progress& progress)
{
    if (!isObjectName(nameOrFile))
        return openMesh(nameOrFile, progress);
    const std::string_view shape = shapeOfObject(nameOrFile);
    const std::filesystem::path file = shape.empty() ? thatLooksLike(nameOrFile).value_or(nameOrFile) : std::filesystem::path();
    auto maps = shape.empty() ? readObjectMaps(file, progress) : bakedShape(nameOrFile, shape, progress);
    if (!maps)
        return tl::unexpected(maps.error());
    std::string name = shape.empty() ? file.filename().string() : std::string(shape);
    if (shape.empty())
        name.resize(name.size() - kObjectSuffix.size());
    auto mesh = boxMesh(maps->object, name);
    if (!mesh)
        return mesh;
    mesh->warnings = std::move(maps->warnings); // of the box there is nothing to tell
    maps->object.center = 0.5 * (glm::dvec3(mesh->boundsMin) + glm::dvec3(mesh->boundsMax)); // a box from far away has been moved
    mesh->object = std::make_shared<const ObjectMaps>(std::move(*maps));
    return mesh;
}

} // namespace relievo
