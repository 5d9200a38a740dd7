// The mesh of a glTF file and the scene that shows it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/glb_file.h"
#include "core/mesh/mesh.h"

namespace relievo {

// One primitive a part: of material 0, or of material 1 where `isPlain` says so. rotation: of the material, degrees.
void addMesh(GlbFile& file, const Mesh& mesh, const std::vector<char>& isPlain, float rotation);

} // namespace relievo
