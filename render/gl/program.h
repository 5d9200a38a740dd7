// A linked shader program whose uniforms are set from the tables.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "render/gl/gl_objects.h"

namespace relievo {

class LinkedProgram {
public:
    // Errors carry the driver's message with file:line.
    static Expected<LinkedProgram> link(const ProgramText& text);

    void use() const { glUseProgram(*m_program); }
    // Rows whose uniform the program does not have cost nothing.
    void set(const Parameters& parameters) const;
    void set(const SceneUniforms& uniforms) const;
    void set(const char* name, float value) const;
    void set(const char* name, const std::vector<glm::vec4>& values) const; // of an array, from its first element on
    void set(const std::array<glm::ivec4, 3>& objectAxes, const std::array<int, 48>& objectLevels) const; // core/object/object_texels.h
    // Binds to a texture unit when the program reads `name`; returns whether it does.
    bool bind(const char* sampler, GLenum target, GLuint texture, int unit) const;
    bool reads(const char* name) const { return glGetUniformLocation(*m_program, name) >= 0; }

private:
    Program m_program;
};

} // namespace relievo
