// Writing the maps of a relief object that is baked from a mesh, and the file that names them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include "core/object/bake/bake_object.h"

namespace relievo {

struct ObjectJob {
    const MeshSurface* surface = nullptr;
    ObjectOptions options;
    std::filesystem::path folder;
    std::filesystem::path meshFile; // which is not replaced; may be empty
    Progress progress;
};

// resources/help/objects.md, "The file". NAME is the mesh's. Nothing that was read is replaced; when it fails, what it made is gone again.
// Baked axis by axis, so that only one axis' pictures are in memory. Errors: those of the bake and of writing; cancelled.
Expected<Exported> writeObject(const ObjectJob& job);

} // namespace relievo
