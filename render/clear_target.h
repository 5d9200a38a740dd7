// Making a target ready to be drawn on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/draw_request.h"

namespace relievo {

void bindTarget(const Target& target);

// Binds it, sets the OpenGL state that a picture begins with, and fills it with the background; heat: of a view of numbers.
void clearTarget(const Parameters& parameters, const Target& target, bool heat);

} // namespace relievo
