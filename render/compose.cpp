// Composing two pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/compose.h"
#include "render/gl/program.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace relievo {
namespace {
// Of the wipe's line, towards the second picture; y down.
glm::vec2 normalOf(const Composition& composition)
{
    const float angle = glm::radians(composition.angle);
    return {std::cos(angle), std::sin(angle)};
}

void filterFor(unsigned texture, float zoom)
{
    const GLint filter = zoom >= 2.f ? GL_NEAREST : GL_LINEAR;
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
}
} // namespace

bool isSecondAt(const Composition& composition, glm::vec2 at, float aspect)
{
    return glm::dot((at - composition.divider) * glm::vec2(aspect, 1.f), normalOf(composition)) >= 0.f;
}

struct Composer::Impl {
    std::optional<LinkedProgram> program;
    VertexArray noVertices;
    Texture uploaded;
};

Composer::Composer() : m(std::make_unique<Impl>()) { }
Composer::~Composer() = default;

Expected<void> Composer::draw(const ComposedPlace& place, unsigned first, unsigned second, const Composition& composition)
{
    if (!m->program) {
        auto linked = composeProgram(embeddedReader()).and_then(LinkedProgram::link);
        if (!linked)
            return tl::unexpected(linked.error());
        m->program = std::move(*linked);
        m->noVertices = newVertexArray();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
    glViewport(place.x, place.y, place.width, place.height);
    filterFor(first, composition.zoom);
    filterFor(second, composition.zoom);
    const float seen = 1.f / composition.zoom;
    const glm::vec2 normal = normalOf(composition);
    m->program->use();
    m->program->bind("firstPicture", GL_TEXTURE_2D, first, 0);
    m->program->bind("secondPicture", GL_TEXTURE_2D, second, 1);
    m->program->set("composition",
        {glm::vec4(place.x, place.y, place.width, place.height),
            glm::vec4(composition.corner.x, 1.f - composition.corner.y - seen, seen, seen),
            glm::vec4(composition.divider.x * float(place.width), (1.f - composition.divider.y) * float(place.height), normal.x, -normal.y),
            glm::vec4(float(composition.how), composition.gain, composition.lineWidth, 0.f)});
    const GLboolean tested = glIsEnabled(GL_DEPTH_TEST); // one picture over the other
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(*m->noVertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    if (tested)
        glEnable(GL_DEPTH_TEST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
    return {};
}

unsigned Composer::upload(const Image& picture)
{
    if (!m->uploaded)
        m->uploaded = newTexture();
    const std::size_t row = std::size_t(picture.width) * 4;
    std::vector<std::byte> flipped(picture.data.size());
    for (std::size_t y = 0; y < std::size_t(picture.height); ++y)
        std::copy_n(picture.data.begin() + std::ptrdiff_t(y * row), row,
            flipped.begin() + std::ptrdiff_t((std::size_t(picture.height) - 1 - y) * row));
    glBindTexture(GL_TEXTURE_2D, *m->uploaded);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, flipped.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return *m->uploaded;
}

} // namespace relievo
