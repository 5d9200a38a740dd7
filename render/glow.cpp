// Spreading light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/glow.h"
#include "render/gl/driver_limits.h"
#include "render/gl/scoped_state.h"
#include <algorithm>

namespace relievo {

namespace {
constexpr int kLeastSide = 8; // pixels of the smallest level
constexpr float kReach = 4.f; // texels of a level over which it spreads light: those of the tents down to it and up from it

// How much of the glow a level holds that spreads light over so many of the glow's sizes: most near 1, little of what is far wider.
float weightOf(float sizes)
{
    return sizes / (1.f + sizes * sizes * sizes);
}

// About half the picture's, and from there on exact halves: others would weigh single texels unevenly. The whole of a tiny picture.
std::vector<glm::ivec2> levelSizes(glm::ivec2 whole)
{
    int halvings = 0;
    while (std::min(whole.x, whole.y) >> (halvings + 1) >= kLeastSide)
        ++halvings;
    if (halvings == 0)
        return {whole};
    const int unit = 1 << halvings;
    std::vector<glm::ivec2> sizes;
    for (int i = 1; i <= halvings; ++i)
        sizes.push_back((whole + unit / 2) / unit * (unit >> i));
    return sizes;
}
} // namespace

Expected<void> Glow::resize(int width, int height)
{
    if (!m_levels.empty() && m_size == glm::ivec2(width, height))
        return {};
    m_levels.clear();
    m_size = {width, height};
    for (const glm::ivec2& size : levelSizes({width, height})) {
        m_levels.push_back({newColors(GL_RGBA16F, size.x, size.y, GL_LINEAR), newFramebuffer(), size.x, size.y});
        glBindFramebuffer(GL_FRAMEBUFFER, *m_levels.back().framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *m_levels.back().texture, 0);
        if (const auto drawable = canBeDrawnTo(size.x, size.y); !drawable) {
            m_levels.clear();
            return drawable;
        }
    }
    return {};
}

const LinkedProgram* Glow::ready(GlowStep step, const ProgramFeatures& features, const Parameters& parameters,
    const SceneUniforms& uniforms, ProgramCache& programs, std::optional<Error>& error) const
{
    std::string name = "glow/" + std::to_string(int(step));
    if (step == GlowStep::Glowing)
        name += features.linear ? "/linear" : '/' + std::to_string(features.variant(&Parameters::toneCurve));
    const LinkedProgram* program = programs.get(
        name, [&](const ShaderReader& read) { return glowProgram(step, features, read); }, error);
    if (program) {
        program->use();
        program->set(parameters);
        program->set(uniforms);
    }
    return program;
}

namespace {
void cover(const LinkedProgram& program, unsigned framebuffer, int width, int height, glm::vec4 place)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    program.set("glowPlace", {place});
    glDrawArrays(GL_TRIANGLES, 0, 3);
}
} // namespace

// Down to the smallest level, and up again, each level's share of the glow over what comes from below.
void Glow::spread(const LinkedProgram& resized, float size)
{
    const auto draw = [&resized](const Level& from, const Level& to) {
        resized.bind("glowPicture", GL_TEXTURE_2D, *from.texture, 0);
        cover(resized, *to.framebuffer, to.width, to.height, {0.f, 0.f, 1.f / float(to.width), 1.f / float(to.height)});
    };
    resized.use();
    for (std::size_t i = 1; i < m_levels.size(); ++i)
        draw(m_levels[i - 1], m_levels[i]);
    const ScopedEnable blending(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    const auto weight = [&](std::size_t level) { return weightOf(kReach / (size * float(m_levels[level].height))); };
    float below = weight(m_levels.size() - 1);
    for (std::size_t i = m_levels.size() - 1; i-- > 0;) {
        const float own = weight(i);
        glBlendColor(0.f, 0.f, 0.f, below / (below + own));
        draw(m_levels[i + 1], m_levels[i]);
        below += own;
    }
}

Expected<void> Glow::draw(const LightPicture& picture, const LightPicture& whole, const Target& target, const ProgramFeatures& features,
    const Parameters& parameters, const SceneUniforms& uniforms, ProgramCache& programs)
{
    if (const auto made = resize(whole.width(), whole.height()); !made)
        return made;
    if (!m_noVertices)
        m_noVertices = newVertexArray();
    std::optional<Error> error;
    const auto step = [&](GlowStep which) { return ready(which, features, parameters, uniforms, programs, error); };
    const LinkedProgram *resized = step(GlowStep::Resized), *glowing = step(GlowStep::Glowing), *excess = step(GlowStep::Excess);
    if (!resized || !glowing || !excess)
        return tl::unexpected(*error);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(*m_noVertices);
    excess->bind("lightPicture", GL_TEXTURE_2D, whole.light(), 0);
    const Level& first = m_levels.front();
    cover(*excess, *first.framebuffer, first.width, first.height,
        {float(whole.width()) / float(first.width), float(whole.height()) / float(first.height), 0.f, 0.f});
    spread(*resized, parameters.bloomSize);
    glowing->use();
    glowing->bind("glowPicture", GL_TEXTURE_2D, *m_levels.front().texture, 0);
    glowing->bind("lightPicture", GL_TEXTURE_2D, picture.light(), 1);
    glowing->bind("shownPicture", GL_TEXTURE_2D, picture.shown(), 2);
    const glm::vec2 size
        = target.wholeWidth > 0 ? glm::vec2(target.wholeWidth, target.wholeHeight) : glm::vec2(target.width, target.height);
    cover(*glowing, target.framebuffer, target.width, target.height, {float(target.left), float(target.below), 1.f / size.x, 1.f / size.y});
    glBindVertexArray(0);
    glEnable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    return error ? tl::unexpected(*error) : Expected<void>();
}

} // namespace relievo
