// Which layer an interval is put in, where there are fewer intervals than layers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/relief_object.h"

namespace relievo {

// Moves the intervals of each texel, which lie in its first layers, to those in which they go on best from the texels at the left and
// above: so a layer follows one part of the surface, and is bilinear there. Their order stays.
void alignLayers(AxisMap& map);

} // namespace relievo
