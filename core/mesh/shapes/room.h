// The corner of a room with a table, by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// Adds a floor 1 m wide and deep with two walls, open towards +x and +z, and in it a plain table with the teapot, and the figure beside it
// (after Policarpo, Oliveira and Comba 2005, figure 2). Frames are not completed yet (frames.h).
void makeRoom(Mesh& mesh);

} // namespace relievo
