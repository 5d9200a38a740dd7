// A walking figure by formula: relief on a skinned mesh without a file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// 1 m high, centred, facing +z; limbs are closed tubes with square texels. Its deformation holds one clip, "walk", that repeats without a
// jump. Frames are not completed yet (frames.h).
void makeCharacter(Mesh& mesh);

} // namespace relievo
