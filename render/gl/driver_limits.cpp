// Asking the driver for its limits and errors.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/driver_limits.h"
#include "core/mesh/animation/pose.h"
#include "render/uploads/pose_upload.h"
#include <algorithm>
#include <epoxy/gl.h>
#include <string>

namespace relievo {

namespace {
std::size_t limitOf(GLenum name)
{
    GLint limit = 0;
    glGetIntegerv(name, &limit);
    return std::size_t(std::max(limit, 0));
}

Expected<void> mapFits(int longest)
{
    const std::size_t limit = limitOf(GL_MAX_TEXTURE_SIZE);
    if (std::size_t(longest) <= limit)
        return {};
    return failure(ErrorCode::Driver, "OpenGL",
        "a map is " + std::to_string(longest) + " texels long and this driver takes " + std::to_string(limit), "Make the map smaller");
}
} // namespace

Expected<void> fitTheDriver(const HeightField& field)
{
    return mapFits(std::max(field.width(), field.height()));
}

Expected<void> fitTheDriver(const Material& material, const Mesh& mesh)
{
    int longest = material.height ? std::max(material.height->width(), material.height->height()) : 0;
    for (const auto& image : material.maps)
        longest = image ? std::max({longest, image->width, image->height}) : longest;
    if (const auto fits = mapFits(longest); !fits)
        return fits;
    const std::size_t texels = mesh.deformation ? morphTexels(mesh) : 0, limit = texels ? limitOf(GL_MAX_TEXTURE_BUFFER_SIZE) : 0;
    if (texels <= limit)
        return {};
    return failure(ErrorCode::Driver, "OpenGL",
        "the morph targets of the mesh take " + std::to_string(texels) + " texels and this driver takes " + std::to_string(limit),
        "Use a mesh with fewer vertices or fewer morph targets");
}

Expected<void> memorySufficed()
{
    bool sufficed = true;
    for (int i = 0; i < 16; ++i) { // a lost context gives errors for ever
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR)
            break;
        sufficed = sufficed && error != GL_OUT_OF_MEMORY;
    }
    if (sufficed)
        return {};
    return failure(ErrorCode::Driver, "OpenGL", "the maps and the mesh do not fit into the graphics memory",
        "Use smaller maps, a smaller shadow map or a mesh of fewer triangles");
}

Expected<void> canBeDrawnTo(int width, int height)
{
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return {};
    return failure(ErrorCode::Driver, "OpenGL",
        "a picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels does not fit into the driver", "Make it smaller");
}

} // namespace relievo
