// What the driver can hold: told beforehand, or found out after it was asked for; else the picture would be black, without a word.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include "core/mesh/mesh.h"

namespace relievo {

// Whether the sizes of maps and morph targets are possible. Needs a current context, as the others do.
Expected<void> fitTheDriver(const HeightField& field);
Expected<void> fitTheDriver(const Material& material, const Mesh& mesh);

// Whether there was memory for all uploads since the last call; forgets other errors of OpenGL.
Expected<void> memorySufficed();

// Whether the framebuffer that is bound, of this size, can be drawn to.
Expected<void> canBeDrawnTo(int width, int height);

} // namespace relievo
