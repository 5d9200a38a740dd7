// Uploading what programs read, when they first read it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/uploads.h"
#include "render/gl/texture_units.h"
#include <algorithm>
#include <cmath>

namespace relievo {

void bindAccelerationMap(const LinkedProgram& program, const AccelerationUpload& upload, int unit)
{
    program.bind(std::string(upload.sampler).c_str(), upload.target, *upload.texture, unit);
    program.set("boundScales[0]", upload.scales);
}

void Uploads::show(const Resources& resources, std::size_t panes)
{
    std::erase_if(m_exact, [panes](const auto& entry) { return entry.first >= panes; });
    if (resources.environment != m_resources.environment)
        m_environment = Texture();
    std::erase_if(m_acceleration, [&](const auto& entry) { return !resources.accelerationMaps.holds(entry.first); });
    m_resources = resources;
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
        map = {uploadImage(*image, row(kind).isColor, kind == MapKind::Normal && m_normalsFinely),
            std::log2(float(std::max(image->width, image->height)))};
        m_uploadedMaps[i] = image;
    }
    return map;
}

const Uploads::Map& Uploads::slopes(Wrap wrap)
{
    glActiveTexture(GL_TEXTURE0 + kUploadUnit);
    Map& slopes = m_slopes[wrap];
    if (!m_resources.material->height) // an older program is drawn while the new text is broken
        return slopes;
    const HeightField& field = *m_resources.material->height;
    if (!slopes.texture) {
        slopes = {uploadSlopes(field.withWrap(wrap)), std::log2(float(std::max(field.width(), field.height())))};
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

namespace {
// Of the texture bound last; heights are searched, not shown, and keep theirs.
void setFilter(const MapKindRow& row, bool filters)
{
    if (row.kind == MapKind::Height)
        return;
    const GLint usual = row.channels == 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filters ? usual : GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filters ? GL_LINEAR : GL_NEAREST);
}
} // namespace

const AccelerationUpload& Uploads::uploaded(const std::shared_ptr<const AccelerationMap>& map, Wrap wrap)
{
    glActiveTexture(GL_TEXTURE0 + kUploadUnit);
    Acceleration& kept = m_acceleration[map.get()];
    if (!kept.map)
        kept = {map, uploadAccelerationMap(*map, wrap)};
    return kept.upload;
}

void Uploads::bindMaps(const LinkedProgram& program, const Parameters& parameters,
    const std::shared_ptr<const AccelerationMap>& acceleration, const std::shared_ptr<const AccelerationMap>& horizons)
{
    const Wrap wrap = parameters.wrap;
    if (parameters.normalFiltering != NormalFiltering::Off && !m_normalsFinely) {
        m_normalsFinely = true;
        m_uploadedMaps[std::size_t(MapKind::Normal)] = nullptr;
    }
    int unit = 0;
    for (const MapKindRow& row : kMapKinds)
        if (const std::string sampler = std::string(row.key) + "Map"; program.reads(sampler.c_str())) {
            bindMap(program, sampler, map(row.kind), wrap, unit++);
            setFilter(row, parameters.textureFilter);
        }
    if (program.reads("slopeMap"))
        bindMap(program, "slopeMap", slopes(wrap), wrap, unit++);
    if (m_resources.material->height) {
        const HeightField& field = *m_resources.material->height;
        program.set("heightMapLast", float(levelCount(field) - 1));
    }
    if (acceleration && (program.reads("boundMap") || program.reads("cellMap") || program.reads("distanceMap")))
        bindAccelerationMap(program, uploaded(acceleration, wrap), unit++);
    if (horizons && program.reads("horizonMap")) {
        const Image& finest = horizons->levels.front();
        const int longest = std::max(finest.width, finest.height / horizons->slices);
        program.bind("horizonMap", GL_TEXTURE_2D_ARRAY, *uploaded(horizons, wrap).texture, unit++);
        program.set("horizonMapLevels", std::log2(float(longest)));
    }
    if (program.reads("environmentMap")) {
        glActiveTexture(GL_TEXTURE0 + kUploadUnit);
        if (!m_environment)
            m_environment = uploadEnvironment(*m_resources.environment);
        program.bind("environmentMap", GL_TEXTURE_CUBE_MAP, *m_environment, unit);
    }
}

void Uploads::bindExact(const LinkedProgram& program, std::size_t pane, const std::shared_ptr<const ExactDistances>& exact)
{
    if (!exact)
        m_exact.erase(pane);
    if (!exact || !program.reads("exactMap"))
        return;
    Exact& uploaded = m_exact[pane];
    if (uploaded.distances != exact) {
        glActiveTexture(GL_TEXTURE0 + kUploadUnit);
        uploaded = {exact, uploadDistances(exact->pixels)};
    }
    program.bind("exactMap", GL_TEXTURE_2D, *uploaded.texture, kExactUnit);
}

int Uploads::textureCount() const
{
    const auto count = [](const auto& maps) { return int(std::ranges::count_if(maps, [](const Map& map) { return bool(map.texture); })); };
    return count(m_maps) + count(m_slopes.values) + int(m_acceleration.size()) + (m_environment ? 1 : 0) + int(m_exact.size());
}

} // namespace relievo
