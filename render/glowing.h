// Pictures with a glow: their passes drawn off-screen, spread, and put together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/glow.h"
#include <functional>

namespace relievo {

// What a picture was drawn with, and what its shaders had to say.
struct DrawnFrame {
    Parameters parameters;
    ProgramFeatures features;
    SceneUniforms uniforms;
    std::optional<Error> error;
};

bool hasGlow(const DrawRequest& request); // else nothing here is needed

class GlowingPictures {
public:
    // passes: draws all of a request into its target. Rows of a picture come in order from below, no other picture between them, and are
    // put into the target with the last one. Errors: those of the passes, or there is no memory.
    Expected<void> draw(
        const DrawRequest& request, const std::function<Expected<DrawnFrame>(const DrawRequest&)>& passes, ProgramCache& programs);

private:
    LightPicture m_picture, m_whole; // the latter of a picture that is drawn in tiles: all of it in fewer pixels
    Glow m_glow;
};

} // namespace relievo
