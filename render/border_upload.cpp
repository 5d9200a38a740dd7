// Uploading borders.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/border_upload.h"
#include "core/mesh/borders.h"
#include <algorithm>

namespace relievo {

BorderUpload uploadBorders(const Mesh& mesh)
{
    GLint limit = 0; // texels
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    const std::size_t triangles = mesh.indices.size() / 3, room = std::size_t(std::max(limit, 0));
    BorderLimits limits;
    limits.budget = std::min(limits.budget, room - std::min(triangles, room));
    const Borders borders = bordersOf(mesh, limits);
    if (borders.segments.empty())
        return {};
    std::vector<glm::vec4> texels;
    texels.reserve(triangles + borders.segments.size());
    for (std::size_t i = 0; i < triangles; ++i)
        texels.emplace_back(float(triangles + borders.starts[i]), float(borders.starts[i + 1] - borders.starts[i]), 0.f, 0.f);
    texels.insert(texels.end(), borders.segments.begin(), borders.segments.end());
    BorderUpload upload{newBuffer(), newTexture()};
    glBindBuffer(GL_TEXTURE_BUFFER, *upload.buffer);
    glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size() * sizeof(glm::vec4)), texels.data(), GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, *upload.texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, *upload.buffer);
    return upload;
}

} // namespace relievo
