// Clearing a target.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/clear_target.h"
#include <cmath>
#include <epoxy/gl.h>

namespace relievo {

namespace {
constexpr float kPlainBackground[] = {0.0331f, 0.0331f, 0.0331f}; // linear; sRGB 51 of 255

float srgb(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.f / 2.4f) - 0.055f;
}
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
    const bool transparent = parameters.background == Backdrop::Transparent || (target.linear && heat);
    float color[4] = {0.f, 0.f, 0.f, transparent ? 0.f : 1.f};
    for (int i = 0; i < 3 && !transparent; ++i)
        color[i] = target.linear ? kPlainBackground[i] : srgb(kPlainBackground[i]);
    glClearColor(color[0], color[1], color[2], color[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

} // namespace relievo
