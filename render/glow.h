// The glow around what is bright: its light spread over the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "render/draw_request.h"
#include "render/gl/program_cache.h"
#include "render/light_picture.h"
#include <optional>
#include <vector>

namespace relievo {

// Spreads light over the whole picture by a pyramid of smaller ones (Burt and Adelson 1983; Jimenez 2014, Next Generation Post
// Processing in Call of Duty: Advanced Warfare), and puts it there. At the picture's borders it is
// mirrored, so that none is lost. All calls need the context current in which it was made.
class Glow {
public:
    // `picture`, with the glow of `whole`, which is the same or, of a tile, all of the picture in fewer pixels; into `target`, whose depth
    // is not written. features: how colours are shown. Errors: of shaders, or there is no memory.
    Expected<void> draw(const LightPicture& picture, const LightPicture& whole, const Target& target, const ProgramFeatures& features,
        const Parameters& parameters, const SceneUniforms& uniforms, ProgramCache& programs);

private:
    struct Level {
        Texture texture;
        FramebufferName framebuffer;
        int width = 0, height = 0;
    };
    const LinkedProgram* ready(GlowStep step, const ProgramFeatures& features, const Parameters& parameters, const SceneUniforms& uniforms,
        ProgramCache& programs, std::optional<Error>& error) const;
    Expected<void> resize(int width, int height);
    void spread(const LinkedProgram& resized, float size);

    std::vector<Level> m_levels; // the first about half as large as the whole picture, each other half as large as the one before it
    glm::ivec2 m_size{0}; // of the picture that they are for
    VertexArray m_noVertices;
};

} // namespace relievo
