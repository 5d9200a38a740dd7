// OpenGL by libepoxy, without Qt.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/gl_calls.h"
#include <epoxy/gl.h>
#include <string>

namespace relievo {

Expected<void> openGLSuffices()
{
    const int version = epoxy_gl_version();
    if (version >= 41)
        return {};
    return failure(ErrorCode::Driver, "OpenGL " + std::to_string(version / 10) + '.' + std::to_string(version % 10), "OpenGL 4.1 is needed",
        "Update the graphics driver");
}

void clearTo(unsigned framebuffer, float red, float green, float blue)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glClearColor(red, green, blue, 1.f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finishDrawing()
{
    glFinish();
}

void copyTo(const Framebuffer& from, unsigned framebuffer, const PaneArea& to)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.handle());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, from.width(), from.height(), to.x, to.y, to.x + to.width, to.y + to.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

} // namespace relievo
