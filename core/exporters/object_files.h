// Writing the maps of a relief object that is baked from a mesh, the file that names them, and a project that shows it.
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
    std::string source; // the mesh: a built-in shape, or a file, which is not replaced; "": not told
    Progress progress;
};

// resources/help/objects.md, "The file". NAME is the mesh's; the last file is NAME.object.json, the one before it NAME.relievo. Nothing
// that was read is replaced; when it fails, what it made is gone again. Baked axis by axis, so that only one axis' pictures are in memory.
// Errors: those of the bake and of writing; cancelled.
Expected<Exported> writeObject(const ObjectJob& job);

} // namespace relievo
