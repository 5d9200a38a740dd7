// A teapot of our own, by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// Adds a pot with lid, bent spout and handle, each closed and smooth, 1 m from the spout to the handle. Whole tiles around each piece,
// texels about square; the size of a tile differs from piece to piece by less than two.
void makeTeapot(Mesh& mesh);

} // namespace relievo
