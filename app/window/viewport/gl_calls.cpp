// OpenGL by libepoxy, without Qt.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/gl_calls.h"
#include <algorithm>
#include <epoxy/gl.h>
#include <string>
#include <vector>

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

Image readPixels(unsigned framebuffer, int width, int height, const PaneArea& of)
{
    Image read{.width = of.width, .height = of.height, .channels = 4, .data = {}};
    read.data.assign(read.texelCount() * 4, std::byte(0));
    const int left = std::max(of.x, 0), right = std::min(of.x + of.width, width);
    const int top = std::max(of.y, 0), bottom = std::min(of.y + of.height, height);
    if (left >= right || top >= bottom)
        return read;
    std::vector<std::byte> part(std::size_t(right - left) * std::size_t(bottom - top) * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(left, height - bottom, right - left, bottom - top, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    const std::size_t row = std::size_t(right - left) * 4;
    for (int y = top; y < bottom; ++y) // from below
        std::copy_n(part.begin() + std::ptrdiff_t(row * std::size_t(bottom - 1 - y)), row,
            read.data.begin() + (std::ptrdiff_t(y - of.y) * of.width + (left - of.x)) * 4);
    return read;
}

} // namespace relievo
