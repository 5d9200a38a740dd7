// Clearing a target.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/clear_target.h"
#include "core/ground/srgb.h"
#include <epoxy/gl.h>

namespace relievo {

namespace {
const glm::vec3 kPlainBackground(0.0331f); // linear; sRGB 51 of 255
} // namespace

void bindTarget(const Target& target)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    if (target.rows > 0) {
        glScissor(0, target.firstRow, target.width, target.rows);
        glEnable(GL_SCISSOR_TEST);
    } else {
        glDisable(GL_SCISSOR_TEST);
    }
}

void clearTarget(const Parameters& parameters, const Target& target, bool heat)
{
    bindTarget(target);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_CULL_FACE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS); // else the edges of the small levels show
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const glm::vec3 behind = parameters.background == Backdrop::Color && !heat ? parameters.backgroundColor : kPlainBackground;
    const bool transparent = parameters.background == Backdrop::Transparent || (target.linear && heat);
    float color[4] = {0.f, 0.f, 0.f, transparent ? 0.f : 1.f};
    for (int i = 0; i < 3 && !transparent; ++i)
        color[i] = target.linear ? behind[i] : srgbOf(behind[i]);
    glClearColor(color[0], color[1], color[2], color[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

} // namespace relievo
