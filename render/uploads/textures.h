// Textures made of maps, environments and distances, in the current context. Each call binds what it makes to the active texture unit.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/environment/environment.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/trace/displaced_mesh.h"
#include "render/gl/gl_objects.h"
#include <glm/vec4.hpp>
#include <string_view>
#include <vector>

namespace relievo {

// A map of a material with mip levels; isColor: sRGB, decoded by the texture unit.
// finely: mip levels in 16 bits, of 8-bit images too, whose rounding grows from level to level.
Texture uploadImage(const Image& image, bool isColor, bool finely = false);

// A height field as a texture with linear filtering and mip levels: R16 when its source had at most 16 bits (exact, and not
// filtered in 8-bit fixed point as R8 is on some rasterisers), R32F else.
Texture uploadHeight(const HeightField& field, bool mips = true);

// dh/du and dh/dv of the field, per tile, under its wrap mode.
Texture uploadSlopes(const HeightField& field);

// An acceleration map as textures of its kind: floats with linear filter, whole numbers, or a volume. Wrap mode as given.
struct AccelerationUpload {
    Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::string_view sampler; // the name it has in shaders
    std::vector<glm::vec4> scales;
};
AccelerationUpload uploadAccelerationMap(const AccelerationMap& map, Wrap wrap);

// A cube map whose levels are those of the environment.
Texture uploadEnvironment(const Environment& environment);

// Metres from the eye, -1 where they are not known; and by how much those may be off.
Texture uploadDistances(const PixelDistances& distances);

} // namespace relievo
