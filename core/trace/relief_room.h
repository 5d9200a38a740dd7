// How deep a relief may go into a mesh before the mesh is used up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// m: so deep the surface can be moved in along its normals while at most one part in a hundred of it is turned over by its own curvature or
// has passed the middle between itself and the other side. Infinity for a mesh that no relief comes to the end of, and where Embree cannot
// be used. At most 20,000 triangles are asked, evenly chosen.
float reliefRoom(const Mesh& mesh);

// m by which the corners of a triangle may be moved in along their normals until it turns over (once, or both ways at once, as at the
// middle of a sphere); infinity when it never does.
float turningDepth(const Vertex& a, const Vertex& b, const Vertex& c);

} // namespace relievo
