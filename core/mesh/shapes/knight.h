// A chess knight by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"

namespace relievo {

// Adds a knight 1 m high that looks towards +x: a turned base, neck and head, mane and ears, each a closed surface that reaches into the
// others (for relief objects; after the RTM report, section 5.3). Frames are not completed yet (frames.h).
void makeKnight(Mesh& mesh);

} // namespace relievo
