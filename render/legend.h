// The numbered legend of a heat map, drawn into a picture that no window will annotate.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include <string_view>

namespace relievo {

// Draws the heat colours with the numbers 0, half and all of `range`, and `unit`, into the lower left corner of an RGBA U8 picture.
// Pictures narrower than 160 or lower than 60 pixels stay as they are.
void drawLegend(Image& picture, float range, std::string_view unit);

} // namespace relievo
