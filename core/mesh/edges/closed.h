// Whether a mesh encloses a volume.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// True when no way leads inside: every edge (between positions, whatever their normals and UVs) is run through as often in one direction as
// in the other, and the triangles face outwards on the whole. The inside of such a mesh is never seen.
bool isClosed(const Mesh& mesh);

} // namespace relievo
