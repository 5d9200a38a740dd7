// Compiling, linking and feeding shader programs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/program.h"
#include <algorithm>
#include <array>
#include <string>

namespace relievo {

namespace {

template <class GetInt, class GetLog> std::string logOf(GLuint name, GetInt getInt, GetLog getLog)
{
    GLint length = 0;
    getInt(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    getLog(name, length, nullptr, log.data());
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n'))
        log.pop_back();
    return log;
}

Expected<Shader> compile(GLenum stage, const ShaderText& text)
{
    Shader shader(glCreateShader(stage));
    const char* source = text.text.c_str();
    glShaderSource(*shader, 1, &source, nullptr);
    glCompileShader(*shader);
    GLint good = 0;
    glGetShaderiv(*shader, GL_COMPILE_STATUS, &good);
    if (good)
        return shader;
    const std::string log = namedLog(logOf(*shader, glGetShaderiv, glGetShaderInfoLog), text);
    return failure(ErrorCode::Driver, "shaders", log.substr(0, log.find('\n')), "Mend the shader; the last picture is kept");
}

struct SetUniform {
    GLint at;
    void operator()(float v) const { glUniform1f(at, v); }
    void operator()(int v) const { glUniform1i(at, v); }
    void operator()(bool v) const { glUniform1i(at, v); }
    template <IsChoice E> void operator()(E v) const { glUniform1i(at, int(v)); }
    void operator()(const glm::vec2& v) const { glUniform2f(at, v.x, v.y); }
    void operator()(const glm::vec3& v) const { glUniform3f(at, v.x, v.y, v.z); }
    void operator()(const glm::mat2& v) const { glUniformMatrix2fv(at, 1, GL_FALSE, &v[0][0]); }
    void operator()(const glm::mat4& v) const { glUniformMatrix4fv(at, 1, GL_FALSE, &v[0][0]); }
    template <std::size_t n> void operator()(const std::array<glm::mat4, n>& v) const
    {
        glUniformMatrix4fv(at, GLsizei(n), GL_FALSE, &v.front()[0][0]);
    }
};

} // namespace

Expected<LinkedProgram> LinkedProgram::link(const ProgramText& text)
{
    const auto vertex = compile(GL_VERTEX_SHADER, text.vertex);
    if (!vertex)
        return tl::unexpected(vertex.error());
    const auto fragment = compile(GL_FRAGMENT_SHADER, text.fragment);
    if (!fragment)
        return tl::unexpected(fragment.error());
    LinkedProgram linked;
    linked.m_program = Program(glCreateProgram());
    glAttachShader(*linked.m_program, **vertex);
    glAttachShader(*linked.m_program, **fragment);
    glLinkProgram(*linked.m_program);
    GLint good = 0;
    glGetProgramiv(*linked.m_program, GL_LINK_STATUS, &good);
    if (!good)
        return failure(ErrorCode::Driver, "shaders", logOf(*linked.m_program, glGetProgramiv, glGetProgramInfoLog),
            "Mend the shader; the last picture is kept");
    return linked;
}

void LinkedProgram::set(const Parameters& parameters) const
{
    for (const ParameterRow& row : kParameters)
        if (const GLint at = glGetUniformLocation(*m_program, row.key.data()); at >= 0)
            std::visit([&](auto member) { SetUniform{at}(parameters.*member); }, row.member);
}

void LinkedProgram::set(const SceneUniforms& uniforms) const
{
    for (const SceneUniformRow& row : kSceneUniforms)
        if (const GLint at = glGetUniformLocation(*m_program, row.name.data()); at >= 0)
            std::visit([&](auto member) { SetUniform{at}(uniforms.*member); }, row.member);
}

void LinkedProgram::set(const char* name, float value) const
{
    if (const GLint at = glGetUniformLocation(*m_program, name); at >= 0)
        glUniform1f(at, value);
}

void LinkedProgram::set(const char* name, const std::vector<glm::vec4>& values) const
{
    if (const GLint at = glGetUniformLocation(*m_program, name); at >= 0)
        glUniform4fv(at, GLsizei(values.size()), &values.front().x);
}

void LinkedProgram::set(const std::array<glm::ivec4, 3>& objectAxes, const std::array<int, 48>& objectLevels) const
{
    if (const GLint at = glGetUniformLocation(*m_program, "objectAxes"); at >= 0)
        glUniform4iv(at, GLsizei(objectAxes.size()), &objectAxes.front().x);
    if (const GLint at = glGetUniformLocation(*m_program, "objectLevels"); at >= 0)
        glUniform1iv(at, GLsizei(objectLevels.size()), objectLevels.data());
}

bool LinkedProgram::bind(const char* sampler, GLenum target, GLuint texture, int unit) const
{
    const GLint at = glGetUniformLocation(*m_program, sampler);
    if (at < 0)
        return false;
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(target, texture);
    glUniform1i(at, unit);
    return true;
}

} // namespace relievo
