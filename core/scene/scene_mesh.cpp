// Meshes by their readers, objects as the boxes that they are drawn in.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_mesh.h"
#include "core/ground/name_forms.h"
#include "core/mesh/readers/raw_mesh.h"
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

Expected<Mesh> openSceneMesh(const std::string& nameOrFile, const Progress& progress)
{
    if (!isObjectName(nameOrFile))
        return openMesh(nameOrFile, progress);
    const std::filesystem::path file = thatLooksLike(nameOrFile).value_or(nameOrFile);
    auto maps = readObjectMaps(file, progress);
    if (!maps)
        return tl::unexpected(maps.error());
    std::string name = file.filename().string();
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
