// Texels in a buffer, pictures of the sides in layers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/object_upload.h"
#include "render/gl/texture_units.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
struct Channels {
    const std::optional<Image>& image;
    std::vector<float> without; // values of texels that no picture tells
};

// Sides of axes with other sizes are read at the nearest texel.
template <class T> void fill(std::span<T> layer, int size[2], int first, int stride, const Channels& channels)
{
    const float most = float(std::numeric_limits<T>::max());
    for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
            for (std::size_t c = 0; c < channels.without.size(); ++c) {
                float value = channels.without[c];
                if (channels.image)
                    value = channels.image->value(x * channels.image->width / size[0], y * channels.image->height / size[1],
                        std::min(int(c), channels.image->channels - 1));
                layer[std::size_t((y * size[0] + x) * stride + first) + c] = T(std::clamp(value, 0.f, 1.f) * most + 0.5f);
            }
}

void finishLayers()
{
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, side, GL_CLAMP_TO_EDGE);
}

Texture uploadColors(const ObjectMaps& maps, int size[2])
{
    constexpr float kGrey = 0.735f; // sRGB of one half
    std::vector<std::uint8_t> layer(std::size_t(size[0]) * std::size_t(size[1]) * 4, 255);
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, *texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_SRGB8_ALPHA8, size[0], size[1], 6, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (std::size_t side = 0; side < maps.looks.size(); ++side) {
        fill(std::span(layer), size, 0, 4, {maps.looks[side].color, {kGrey, kGrey, kGrey}});
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, GLint(side), size[0], size[1], 1, GL_RGBA, GL_UNSIGNED_BYTE, layer.data());
    }
    finishLayers();
    return texture;
}

Texture uploadNormals(const ObjectMaps& maps, int size[2])
{
    std::vector<std::uint16_t> layer(std::size_t(size[0]) * std::size_t(size[1]) * 4);
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, *texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16, size[0], size[1], 6, 0, GL_RGBA, GL_UNSIGNED_SHORT, nullptr);
    for (std::size_t side = 0; side < maps.looks.size(); ++side) {
        fill(std::span(layer), size, 0, 4, {maps.looks[side].normal, {0.5f, 0.5f, 1.f}});
        fill(std::span(layer), size, 3, 4, {maps.looks[side].roughness, {0.5f}});
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, GLint(side), size[0], size[1], 1, GL_RGBA, GL_UNSIGNED_SHORT, layer.data());
    }
    finishLayers();
    return texture;
}
} // namespace

void ObjectUpload::bind(const LinkedProgram& program, const ObjectMaps& maps)
{
    if (!program.reads("objectMap"))
        return;
    glActiveTexture(GL_TEXTURE0 + kUploadUnit);
    if (!m_texels) {
        m_buffer = newBuffer(), m_texels = newTexture();
        glBindBuffer(GL_TEXTURE_BUFFER, *m_buffer);
        glBufferData(
            GL_TEXTURE_BUFFER, GLsizeiptr(maps.texels.texels.size() * sizeof(Interval)), maps.texels.texels.data(), GL_STATIC_DRAW);
        glBindTexture(GL_TEXTURE_BUFFER, *m_texels);
        glTexBuffer(GL_TEXTURE_BUFFER, GL_RG16, *m_buffer);
    }
    int size[2] = {1, 1};
    for (const SideLook& look : maps.looks)
        for (const auto* image : {&look.color, &look.normal, &look.roughness})
            if (*image)
                size[0] = std::max(size[0], (*image)->width), size[1] = std::max(size[1], (*image)->height);
    m_levels = std::log2(float(std::max(size[0], size[1])));
    if (!m_colors && program.reads("objectColorMap"))
        m_colors = uploadColors(maps, size);
    if (!m_normals && program.reads("objectNormalMap"))
        m_normals = uploadNormals(maps, size);
    program.set(maps.texels.axes, maps.texels.levels);
    program.bind("objectMap", GL_TEXTURE_BUFFER, *m_texels, kBorderUnit);
    if (m_colors)
        program.bind("objectColorMap", GL_TEXTURE_2D_ARRAY, *m_colors, kPoseUnit);
    if (m_normals)
        program.bind("objectNormalMap", GL_TEXTURE_2D_ARRAY, *m_normals, kMorphUnit);
    program.set("objectMapLevels", m_levels);
}

} // namespace relievo
