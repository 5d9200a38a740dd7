// Reading a relief object from the file that names its maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/image.h"
#include "core/object/object_texels.h"
#include <filesystem>
#include <optional>

namespace relievo {

struct ObjectRead {
    ReliefObject object;
    Warnings warnings; // those of checkObject; "side-missing": the object reaches to that side of its box
};

// resources/help/objects.md, "The file". Errors name the file or the map: no JSON of this kind, numbers that make no box, maps that cannot
// be read, sides of one axis or layers that differ in size, no side at all.
Expected<ObjectRead> readObject(const std::filesystem::path& file);

// What a side's pictures show (core/object/bake/side_pictures.h).
struct SideLook {
    std::optional<Image> color, normal, roughness;
};
// All that pictures of an object are drawn from; kObjectSides in order.
struct ObjectMaps {
    ReliefObject object;
    ObjectTexels texels;
    std::array<SideLook, 6> looks;
    std::string source; // the mesh that it stands for: a built-in shape, or an absolute path; "": not told
    Warnings warnings; // those of readObject; "side-picture-missing": one that cannot be read
};
// What pictures do not bring: normals of the depths, colours and roughness of the axis' other side, whose pictures lie on the same texels.
void completeLooks(ObjectMaps& maps);
// Completed so. Errors: as readObject; cancelled.
Expected<ObjectMaps> readObjectMaps(const std::filesystem::path& file, const Progress& progress = {});

} // namespace relievo
