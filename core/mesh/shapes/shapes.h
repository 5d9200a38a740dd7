// Meshes by formula (ARCHITECTURE.md, "Space, sign and unit"): 1 m in their largest size, centred, y up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/state/shapes.h"
#include <optional>

namespace relievo {

// key: a row of kShapes; nothing for any other name. Texels are about square; seams repeat whole tiles.
std::optional<Mesh> makeShape(std::string_view key);

} // namespace relievo
