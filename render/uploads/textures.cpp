// From pixels to textures: formats, filters and mip levels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/textures.h"
#include "core/maps/surface/normal.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// minification: GL_LINEAR_MIPMAP_LINEAR where a step between mip levels would show (colours, normals), GL_LINEAR_MIPMAP_NEAREST at half
// the cost where it does not (scalar maps) or where levels must not mix (heights), GL_LINEAR without mip levels.
void setFilter(GLint minification)
{
    if (minification != GL_LINEAR)
        glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minification);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

float decodedSrgb(float v)
{
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

struct Format {
    GLint internal;
    GLenum layout, type;
};

Format formatOf(const Image& image, bool isColor, bool finely)
{
    constexpr GLenum layouts[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const std::size_t channels = std::size_t(image.channels - 1);
    const GLenum layout = layouts[channels];
    constexpr GLint sixteen[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
    if (image.type == PixelType::U8 && finely)
        return {sixteen[channels], layout, GL_UNSIGNED_BYTE};
    if (image.type == PixelType::U8) {
        constexpr GLint linear[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
        return {isColor && channels >= 2 ? (channels == 3 ? GL_SRGB8_ALPHA8 : GL_SRGB8) : linear[channels], layout, GL_UNSIGNED_BYTE};
    }
    if (image.type == PixelType::U16 && !isColor)
        return {sixteen[channels], layout, GL_UNSIGNED_SHORT};
    constexpr GLint floats[] = {GL_R16F, GL_RG16F, GL_RGB16F, GL_RGBA16F};
    return {floats[channels], layout, GL_FLOAT};
}

// 16-bit colour has no sRGB texture format: decoded here to half floats, by a table.
std::vector<std::uint16_t> decoded(const Image& image)
{
    std::vector<std::uint16_t> halves(65536);
    tbb::parallel_for(
        std::size_t(0), halves.size(), [&](std::size_t v) { halves[v] = glm::packHalf1x16(decodedSrgb(float(v) / 65535.f)); });
    std::vector<std::uint16_t> values(image.data.size() / sizeof(std::uint16_t));
    const auto* texels = reinterpret_cast<const std::uint16_t*>(image.data.data());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), 1 << 16), [&](const auto& slice) {
        for (std::size_t i = slice.begin(); i < slice.end(); ++i)
            values[i] = halves[texels[i]];
    });
    return values;
}

} // namespace

Texture uploadImage(const Image& image, bool isColor, bool finely)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const Format format = formatOf(image, isColor, finely);
    const auto load = [&](GLenum type, const void* data) {
        glTexImage2D(GL_TEXTURE_2D, 0, format.internal, image.width, image.height, 0, format.layout, type, data);
    };
    if (image.type == PixelType::U16 && isColor)
        load(GL_HALF_FLOAT, decoded(image).data());
    else
        load(format.type, image.data.data());
    setFilter(image.channels == 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

Texture uploadEnvironment(const Environment& environment)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_CUBE_MAP, *texture);
    for (std::size_t level = 0; level < environment.levels.size(); ++level) {
        const Cube& cube = environment.levels[level];
        for (int face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(face), GLint(level), GL_RGB16F, cube.side, cube.side, 0, GL_RGB, GL_FLOAT,
                cube.face(face).data());
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, GLint(environment.levels.size()) - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

namespace {
void uploadHeightLevel(const HeightField& field, int level)
{
    if (field.storedBits() <= 16) {
        std::vector<std::uint16_t> values(field.texels().size());
        std::ranges::transform(field.texels(), values.begin(), [](float h) { return std::uint16_t(h * 65535.f + 0.5f); });
        glTexImage2D(GL_TEXTURE_2D, level, GL_R16, field.width(), field.height(), 0, GL_RED, GL_UNSIGNED_SHORT, values.data());
    } else {
        glTexImage2D(GL_TEXTURE_2D, level, GL_R32F, field.width(), field.height(), 0, GL_RED, GL_FLOAT, field.texels().data());
    }
}
} // namespace

Texture uploadHeight(const HeightField& field, bool mips)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    // Levels of our own: the driver's would not be those that the acceleration maps are baked from.
    const std::vector<HeightField> levels = mips ? heightLevels(field) : std::vector<HeightField>{field};
    for (std::size_t i = 0; i < levels.size(); ++i)
        uploadHeightLevel(levels[i], int(i));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mips ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

AccelerationUpload uploadAccelerationMap(const AccelerationMap& map, Wrap wrap)
{
    AccelerationUpload upload{newTexture(), GL_TEXTURE_2D, map.form == MapForm::Codes ? "cellMap" : "boundMap", map.scales};
    if (map.form == MapForm::Volume) {
        upload.target = GL_TEXTURE_3D, upload.sampler = "distanceMap";
        std::ranges::fill(upload.scales, map.scales.front()); // the finest volume serves all levels
    }
    if (map.form == MapForm::Layers)
        upload.target = GL_TEXTURE_2D_ARRAY, upload.sampler = "horizonMap";
    glBindTexture(upload.target, *upload.texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const int levels = upload.target == GL_TEXTURE_2D ? int(map.levels.size()) : 1;
    for (int i = 0; i < levels; ++i) {
        const Image& image = map.levels[std::size_t(i)];
        const Format format
            = map.form == MapForm::Codes ? Format{GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT} : formatOf(image, false, false);
        if (upload.target != GL_TEXTURE_2D)
            glTexImage3D(upload.target, 0, format.internal, image.width, image.height / map.slices, map.slices, 0, format.layout,
                format.type, image.data.data());
        else
            glTexImage2D(GL_TEXTURE_2D, i, format.internal, image.width, image.height, 0, format.layout, format.type, image.data.data());
    }
    const bool nearest = map.form == MapForm::Codes || map.form == MapForm::Pyramid;
    const GLint mode = wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    if (map.form == MapForm::Layers) { // mip levels are means, as of other maps that are shown
        glGenerateMipmap(upload.target);
        glTexParameteri(upload.target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    } else {
        glTexParameteri(upload.target, GL_TEXTURE_MAX_LEVEL, levels - 1);
        glTexParameteri(upload.target, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST);
    }
    glTexParameteri(upload.target, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_S, mode);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_T, mode);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    return upload;
}

Texture uploadSlopes(const HeightField& field)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    const auto values = slopesOf(field);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, field.width(), field.height(), 0, GL_RG, GL_FLOAT, values.data());
    setFilter(GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

Texture uploadDistances(const PixelDistances& distances)
{
    std::vector<float> rows; // OpenGL's first row is the lowest
    rows.reserve(2 * distances.metres.size());
    constexpr float kMost = std::numeric_limits<float>::max();
    for (int y = distances.height - 1; y >= 0; --y)
        for (int x = 0; x < distances.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(distances.width) + std::size_t(x);
            rows.push_back(std::isnan(distances.metres[i]) ? -1.f : std::min(distances.metres[i], kMost));
            rows.push_back(distances.uncertain.empty() ? 0.f : std::min(distances.uncertain[i], kMost));
        }
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, distances.width, distances.height, 0, GL_RG, GL_FLOAT, rows.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return texture;
}

} // namespace relievo
