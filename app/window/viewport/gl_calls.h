// The few OpenGL calls of the window itself, kept apart because Qt's headers and libepoxy's both claim their names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_layout.h"
#include "core/image/image.h"
#include "render/gl/framebuffer.h"

namespace relievo {

// All need a current context; afterwards the named framebuffer is bound.
Expected<void> openGLSuffices(); // else says what was found and what is needed
void clearTo(unsigned framebuffer, float red, float green, float blue);
void finishDrawing(); // waits until everything is drawn
// Scales `from` to a rectangle of `framebuffer`, y up from below.
void copyTo(const Framebuffer& from, unsigned framebuffer, const PaneArea& to);
// A rectangle of a framebuffer of that size, y down from its upper left corner; transparent where it lies outside: RGBA U8, row 0 at the
// top.
Image readPixels(unsigned framebuffer, int width, int height, const PaneArea& of);

} // namespace relievo
