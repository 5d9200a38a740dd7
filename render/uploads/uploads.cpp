// Uploading maps, meshes and environments.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/uploads.h"
#include "core/maps/surface/normal.h"
#include "core/trace/displaced_mesh.h"
#include "render/gl/texture_units.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// minification: GL_LINEAR_MIPMAP_LINEAR where a step between mip levels would show (colours, normals), GL_LINEAR_MIPMAP_NEAREST at half
// the cost where it does not (scalar maps) or where levels must not mix (heights), GL_LINEAR without mip levels.
void filter(GLint minification)
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

Format formatOf(const Image& image, bool isColor)
{
    constexpr GLenum layouts[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const std::size_t channels = std::size_t(image.channels - 1);
    const GLenum layout = layouts[channels];
    if (image.type == PixelType::U8) {
        constexpr GLint linear[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
        return {isColor && channels >= 2 ? (channels == 3 ? GL_SRGB8_ALPHA8 : GL_SRGB8) : linear[channels], layout, GL_UNSIGNED_BYTE};
    }
    if (image.type == PixelType::U16 && !isColor) {
        constexpr GLint linear[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
        return {linear[channels], layout, GL_UNSIGNED_SHORT};
    }
    constexpr GLint floats[] = {GL_R16F, GL_RG16F, GL_RGB16F, GL_RGBA16F};
    return {floats[channels], layout, GL_FLOAT};
}

// 16-bit colour has no sRGB texture format: decoded here, kept as half floats.
std::vector<float> decoded(const Image& image)
{
    std::vector<float> values(image.texelCount() * std::size_t(image.channels));
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                values[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels) + std::size_t(c)]
                    = decodedSrgb(image.value(x, y, c));
    });
    return values;
}

Texture uploadImage(const Image& image, bool isColor)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const Format format = formatOf(image, isColor);
    const auto load = [&](const void* data) {
        glTexImage2D(GL_TEXTURE_2D, 0, format.internal, image.width, image.height, 0, format.layout, format.type, data);
    };
    if (image.type == PixelType::U16 && isColor)
        load(decoded(image).data());
    else
        load(image.data.data());
    filter(image.channels == 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

// Direction of a cube map's texel, OpenGL's face order and orientation; a, b in [-1, 1].
glm::vec3 cubeDirection(int face, float a, float b)
{
    switch (face) {
    case 0:
        return {1.f, -b, -a};
    case 1:
        return {-1.f, -b, a};
    case 2:
        return {a, 1.f, b};
    case 3:
        return {a, -1.f, -b};
    case 4:
        return {a, -b, 1.f};
    default:
        return {-a, -b, -1.f};
    }
}

// Bilinear read of an equirectangular level (environment.h's orientation).
glm::vec3 equirect(const std::vector<glm::vec3>& level, int width, glm::vec3 direction)
{
    constexpr float pi = 3.14159265f;
    direction = glm::normalize(direction);
    const int height = width / 2;
    const float x = (std::atan2(direction.x, -direction.z) / (2.f * pi) + 0.5f) * float(width) - 0.5f;
    const float y = std::acos(std::clamp(direction.y, -1.f, 1.f)) / pi * float(height) - 0.5f;
    const float fx = x - std::floor(x), fy = y - std::floor(y);
    const auto at = [&](int i, int j) {
        return level[std::size_t(wrapIndex(j, height, Wrap::Clamp)) * std::size_t(width) + std::size_t(wrapIndex(i, width, Wrap::Repeat))];
    };
    const int i = int(std::floor(x)), j = int(std::floor(y));
    return (at(i, j) * (1.f - fx) + at(i + 1, j) * fx) * (1.f - fy) + (at(i, j + 1) * (1.f - fx) + at(i + 1, j + 1) * fx) * fy;
}

Texture uploadEnvironment(const Environment& environment)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_CUBE_MAP, *texture);
    for (int level = 0; level < kEnvironmentLevels; ++level) {
        const int size = kEnvironmentWidth / 4 >> level;
        std::vector<glm::vec3> pixels(std::size_t(size) * std::size_t(size));
        for (int face = 0; face < 6; ++face) {
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const float a = 2.f * (float(x) + 0.5f) / float(size) - 1.f, b = 2.f * (float(y) + 0.5f) / float(size) - 1.f;
                    pixels[std::size_t(y * size + x)]
                        = equirect(environment.levels[std::size_t(level)], kEnvironmentWidth >> level, cubeDirection(face, a, b));
                }
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(face), level, GL_RGB16F, size, size, 0, GL_RGB, GL_FLOAT, pixels.data());
        }
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, kEnvironmentLevels - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

} // namespace

namespace {
void uploadHeightLevel(const HeightField& field, int level)
{
    if (field.storedBits() <= 16) {
        std::vector<std::uint16_t> values(field.texels().size());
        std::ranges::transform(field.texels(), values.begin(), [](float h) { return std::uint16_t(std::lround(h * 65535.f)); });
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
    // Levels of our own: the driver's would not be those that the bound maps are baked from.
    const std::vector<HeightField> levels = mips ? heightLevels(field) : std::vector<HeightField>{field};
    for (std::size_t i = 0; i < levels.size(); ++i)
        uploadHeightLevel(levels[i], int(i));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mips ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

SearchUpload uploadSearchTexture(const SearchTexture& map, Wrap wrap)
{
    SearchUpload upload{newTexture(), GL_TEXTURE_2D, map.form == MapForm::Codes ? "cellMap" : "boundMap", map.scales};
    if (map.form == MapForm::Volume) {
        upload.target = GL_TEXTURE_3D, upload.sampler = "distanceMap";
        std::ranges::fill(upload.scales, map.scales.front()); // the finest volume serves all levels
    }
    glBindTexture(upload.target, *upload.texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const int levels = upload.target == GL_TEXTURE_3D ? 1 : int(map.levels.size());
    for (int i = 0; i < levels; ++i) {
        const Image& image = map.levels[std::size_t(i)];
        const Format format = map.form == MapForm::Codes ? Format{GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT} : formatOf(image, false);
        if (upload.target == GL_TEXTURE_3D)
            glTexImage3D(GL_TEXTURE_3D, 0, format.internal, image.width, image.height / map.slices, map.slices, 0, format.layout,
                format.type, image.data.data());
        else
            glTexImage2D(GL_TEXTURE_2D, i, format.internal, image.width, image.height, 0, format.layout, format.type, image.data.data());
    }
    const bool nearest = map.form == MapForm::Codes || map.form == MapForm::Pyramid;
    const GLint mode = wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    glTexParameteri(upload.target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    glTexParameteri(upload.target, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(upload.target, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_S, mode);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_T, mode);
    glTexParameteri(upload.target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    return upload;
}

void bindSearchTexture(const LinkedProgram& program, const SearchUpload& upload, int unit)
{
    program.bind(std::string(upload.sampler).c_str(), upload.target, *upload.texture, unit);
    program.set("boundScales[0]", upload.scales);
}

void Uploads::hold(const Resources& resources)
{
    if (resources.environment != m_resources.environment)
        m_environment = Texture();
    std::erase_if(m_bounds, [&](const auto& entry) {
        const auto held = resources.bounds.find(entry.first);
        return held == resources.bounds.end() || held->second.texture != entry.second.map;
    });
    m_resources = resources;
    if (!resources.seen)
        m_seen = Texture(), m_uploadedSeen = nullptr;
    if (const auto& height = resources.material->height; m_uploadedSlopes != (height ? height->identity() : nullptr))
        m_slopes = {}, m_uploadedSlopes = nullptr;
    for (const MapKindRow& row : kMapKinds) { // a map that is gone frees its texture
        const std::size_t i = std::size_t(row.kind);
        const Material& material = *m_resources.material;
        if (row.kind == MapKind::Height ? !material.height : !material.maps[i])
            m_maps[i] = Map(), m_uploadedMaps[i] = nullptr;
    }
}

const Uploads::Map& Uploads::map(MapKind kind)
{
    glActiveTexture(GL_TEXTURE0 + kUploadUnit);
    const std::size_t i = std::size_t(kind);
    const Material& material = *m_resources.material;
    Map& map = m_maps[i];
    if (kind == MapKind::Height && material.height) {
        if (m_uploadedMaps[i] != material.height->identity()) {
            map = {uploadHeight(*material.height), std::log2(float(std::max(material.height->width(), material.height->height())))};
            m_uploadedMaps[i] = material.height->identity();
        }
    } else if (const auto& image = material.maps[i]; image && m_uploadedMaps[i] != image) {
        map = {uploadImage(*image, row(kind).isColor), std::log2(float(std::max(image->width, image->height)))};
        m_uploadedMaps[i] = image;
    }
    return map;
}

const Uploads::Map& Uploads::slopes(Wrap wrap)
{
    glActiveTexture(GL_TEXTURE0 + kUploadUnit);
    Map& slopes = m_slopes[wrap == Wrap::Clamp ? 1 : 0];
    if (!m_resources.material->height) // an older program is drawn while the new text is broken
        return slopes;
    const HeightField& field = *m_resources.material->height;
    if (!slopes.texture) {
        slopes = {newTexture(), std::log2(float(std::max(field.width(), field.height())))};
        glBindTexture(GL_TEXTURE_2D, *slopes.texture);
        const auto values = slopesOf(field.withWrap(wrap));
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, field.width(), field.height(), 0, GL_RG, GL_FLOAT, values.data());
        filter(GL_LINEAR_MIPMAP_LINEAR);
        m_uploadedSlopes = field.identity();
    }
    return slopes;
}

void Uploads::bindMap(const LinkedProgram& program, const std::string& sampler, const Map& map, Wrap wrap, int unit)
{
    program.bind(sampler.c_str(), GL_TEXTURE_2D, *map.texture, unit);
    program.set((sampler + "Levels").c_str(), map.levels);
    const GLint mode = wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
}

void Uploads::bindMaps(
    const LinkedProgram& program, Wrap wrap, std::string_view boundKey, const std::shared_ptr<const SearchTexture>& bound)
{
    int unit = 0;
    for (const MapKindRow& row : kMapKinds)
        if (const std::string sampler = std::string(row.key) + "Map"; program.reads(sampler.c_str()))
            bindMap(program, sampler, map(row.kind), wrap, unit++);
    if (program.reads("slopeMap"))
        bindMap(program, "slopeMap", slopes(wrap), wrap, unit++);
    if (m_resources.material->height) {
        const HeightField& field = *m_resources.material->height;
        program.set("heightMapLast", float(levelCount(field) - 1));
    }
    if (bound && (program.reads("boundMap") || program.reads("cellMap") || program.reads("distanceMap"))) {
        glActiveTexture(GL_TEXTURE0 + kUploadUnit);
        UploadedBound& uploaded = m_bounds[{std::string(boundKey), wrap}];
        if (uploaded.map != bound)
            uploaded = {bound, uploadSearchTexture(*bound, wrap)};
        bindSearchTexture(program, uploaded.upload, unit++);
    }
    if (program.reads("environmentMap")) {
        glActiveTexture(GL_TEXTURE0 + kUploadUnit);
        if (!m_environment)
            m_environment = uploadEnvironment(*m_resources.environment);
        program.bind("environmentMap", GL_TEXTURE_CUBE_MAP, *m_environment, unit);
    }
}

void Uploads::bindSeen(const LinkedProgram& program)
{
    if (!program.reads("exactMap"))
        return;
    if (m_uploadedSeen != m_resources.seen) {
        m_uploadedSeen = m_resources.seen;
        const SeenDistances& seen = *m_uploadedSeen;
        std::vector<float> rows; // OpenGL's first row is the lowest
        rows.reserve(seen.metres.size());
        for (int y = seen.height - 1; y >= 0; --y)
            for (int x = 0; x < seen.width; ++x)
                rows.push_back(std::isnan(seen.at(x, y)) ? -1.f : std::min(seen.at(x, y), std::numeric_limits<float>::max()));
        glActiveTexture(GL_TEXTURE0 + kUploadUnit);
        m_seen = newTexture();
        glBindTexture(GL_TEXTURE_2D, *m_seen);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, seen.width, seen.height, 0, GL_RED, GL_FLOAT, rows.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    program.bind("exactMap", GL_TEXTURE_2D, *m_seen, kExactUnit);
}

int Uploads::textureCount() const
{
    const auto count = [](const auto& maps) { return int(std::ranges::count_if(maps, [](const Map& map) { return bool(map.texture); })); };
    return count(m_maps) + count(m_slopes) + int(m_bounds.size()) + (m_environment ? 1 : 0) + (m_seen ? 1 : 0);
}

} // namespace relievo
