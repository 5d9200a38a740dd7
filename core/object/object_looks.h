// Pictures of a relief object's sides that no file brings: normals from its own depths, and parts of packed pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/object/relief_object.h"

namespace relievo {

// One channel alone; inverted: what 0 was is 1. Alpha of an image without stands for 1, other channels that it lacks for its first.
Image channelOf(const Image& image, int channel, bool inverted);

// Tangent-space normals, n / 2 + 1 / 2, whose x and y are the first two channels; z is the positive one that makes them unit (RTM report,
// appendix B.2).
Image normalsOfXy(const Image& image);

// Of the outermost surface that is seen from the front of an axis, or from its back, by central differences in m between neighbours that
// are solid; texels without face the side. 16 bits: red along u, green against v, blue out of the side.
Image normalsOfDepths(const ReliefObject& object, std::size_t axis, bool isBack);

} // namespace relievo
