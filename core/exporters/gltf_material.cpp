// The maps and numbers of a material as textures and factors of glTF.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/gltf_material.h"
#include "core/exporters/map_images.h"
#include "core/exporters/written_pictures.h"
#include "core/gltf/gltf_extensions.h"
#include "core/gltf/gltf_layers.h"
#include "core/maps/float_image.h"
#include "core/state/state_json.h"
#include <algorithm>
#include <glm/trigonometric.hpp>
#include <string_view>

namespace relievo {

namespace {
using Json = GlbJson;

Json tinted(const Parameters& parameters, float color)
{
    const glm::vec3 c = glm::vec3(parameters.tint) * color;
    return {shortest(c.x), shortest(c.y), shortest(c.z), 1.f};
}

class MaterialWriter {
public:
    MaterialWriter(GlbFile& file, const ExportJob& job, const Parameters& parameters, Warnings& warnings)
        : m_file(file)
        , m_job(job)
        , m_parameters(parameters)
        , m_material(*job.resources.material)
        , m_warnings(warnings)
    {
    }

    Expected<Json> write()
    {
        Json material = {{"name", m_job.state.name}};
        for (const auto step : {&MaterialWriter::addColor, &MaterialWriter::addPacked, &MaterialWriter::addNormal,
                 &MaterialWriter::addEmission, &MaterialWriter::addLayers, &MaterialWriter::addRelief}) {
            if (m_job.progress.cancelled())
                return cancelled(m_job.out.string());
            if (Expected<void> added = (this->*step)(material); !added)
                return tl::unexpected(added.error());
        }
        return material;
    }

private:
    // A texture of an 8-bit image, as what a material refers to it by.
    Expected<Json> addTexture(const Image& image, const std::string& name, bool srgb)
    {
        const auto png = pngOf(m_job, image, srgb);
        if (!png)
            return tl::unexpected(png.error());
        return reference(m_file.addTexture(**png, name));
    }

    Json reference(std::size_t texture)
    {
        Json info = {{"index", texture}};
        const Parameters& p = m_parameters;
        if (p.tiling == 1.f && p.offsetU == 0.f && p.offsetV == 0.f && p.rotation == 0.f)
            return info;
        // Its rotation turns the UVs counter-clockwise as seen on the image, which turns the image clockwise: the other way round.
        info["extensions"][kTransformExtension] = {{"offset", {shortest(p.offsetU), shortest(p.offsetV)}},
            {"rotation", shortest(-glm::radians(p.rotation))}, {"scale", {shortest(p.tiling), shortest(p.tiling)}}};
        m_file.use(kTransformExtension);
        return info;
    }

    Expected<void> addColor(Json& material)
    {
        Json& pbr = material["pbrMetallicRoughness"];
        pbr["baseColorFactor"] = tinted(m_parameters, m_material.map(MapKind::Color) ? 1.f : kColorWithoutMap);
        const std::optional<Image> color = baseColorImage(m_material, m_job.size);
        if (!color)
            return {};
        Expected<Json> texture = addTexture(*color, "color", true);
        if (!texture)
            return tl::unexpected(texture.error());
        pbr["baseColorTexture"] = *texture;
        if (m_material.map(MapKind::Opacity)) {
            material["alphaMode"] = "MASK";
            material["alphaCutoff"] = 0.5f;
        }
        return {};
    }

    Expected<void> addPacked(Json& material)
    {
        Json& pbr = material["pbrMetallicRoughness"];
        pbr["roughnessFactor"] = shortest(m_parameters.roughness);
        pbr["metallicFactor"] = m_material.map(MapKind::Metallic) ? shortest(m_parameters.metallic) : 0.;
        const std::optional<Image> packed = packedImage(m_material, m_job.size);
        if (!packed)
            return {};
        Expected<Json> texture = addTexture(*packed, "occlusion_roughness_metallic", false);
        if (!texture)
            return tl::unexpected(texture.error());
        pbr["metallicRoughnessTexture"] = *texture;
        if (m_material.map(MapKind::AmbientOcclusion)) {
            material["occlusionTexture"] = *texture;
            material["occlusionTexture"]["strength"] = shortest(m_parameters.aoStrength);
        }
        return {};
    }

    Expected<void> addNormal(Json& material)
    {
        const std::optional<Image> normal = normalImage(m_material, m_parameters, m_job.progress);
        if (!normal)
            return {};
        Expected<Json> texture = addTexture(eightBit(reduced(*normal, m_job.size, Averaging::Normals), false), "normal", false);
        if (!texture)
            return tl::unexpected(texture.error());
        material["normalTexture"] = *texture;
        material["normalTexture"]["scale"] = shortest(m_parameters.normalStrength);
        return {};
    }

    Expected<void> addEmission(Json& material)
    {
        const Image* emission = m_material.map(MapKind::Emission);
        if (!emission || m_parameters.emission <= 0.f)
            return {};
        // The texture holds no light above 1: what is brighter goes into the strength.
        Image light = reduced(*emission, m_job.size, Averaging::Srgb);
        const float most = std::max(brightest(light), 1.f), strength = most * m_parameters.emission;
        if (most > 1.f)
            for (float& value : floats(light))
                value /= most;
        Expected<Json> texture = addTexture(eightBit(light, true), "emission", true);
        if (!texture)
            return tl::unexpected(texture.error());
        material["emissiveTexture"] = *texture;
        const double factor = shortest(std::min(strength, 1.f));
        material["emissiveFactor"] = {factor, factor, factor};
        if (strength > 1.f) {
            material["extensions"][kBrighterExtension] = {{"emissiveStrength", shortest(strength)}};
            m_file.use(kBrighterExtension);
        }
        return {};
    }

    Expected<void> addLayers(Json& material)
    {
        Parameters p = m_parameters;
        p.anisotropyRotation = std::remainder(p.anisotropyRotation + p.rotation, 360.f); // a file's starts at the mesh's tangent
        const auto isOn = [&p](const char* extension) {
            return std::ranges::any_of(kGltfLayers, [&](const GltfLayerRow& row) {
                return row.decides && row.extension == std::string_view(extension) && p.*row.member != row.without;
            }) || (p.sheen > 0.f && extension == std::string_view(kSheenExtension));
        };
        for (const GltfLayerRow& row : kGltfLayers)
            if (isOn(row.extension)) {
                material["extensions"][row.extension][row.factor] = shortest(p.*row.member * row.unit);
                m_file.use(row.extension);
            }
        if (const glm::vec3 color = p.sheen * p.sheenColor; p.sheen > 0.f)
            material["extensions"][kSheenExtension][kSheenColor] = {shortest(color.r), shortest(color.g), shortest(color.b)};
        return {};
    }

    Expected<void> addRelief(Json& material)
    {
        if (!m_material.height) {
            m_warnings.push_back({"no-height", "The material has no height map: the file holds no relief."});
            return {};
        }
        Expected<Json> texture = addTexture(reduced(heightImage(*m_material.height, 8), m_job.size, Averaging::Plain), "height", false);
        if (!texture)
            return tl::unexpected(texture.error());
        const float measured = m_job.resources.mesh->metresPerUV;
        const std::string technique = techniqueOf(m_job);
        Json numbers = {{"depth", shortest(physicalDepth(m_parameters, measured))}, {"midlevel", shortest(m_parameters.midlevel)},
            {"metresPerUV", shortest(metresPerUV(m_parameters, measured))}, {"technique", technique}, {"minSteps", m_parameters.minSteps},
            {"maxSteps", m_parameters.maxSteps}, {"refineSteps", m_parameters.refineSteps}};
        if (const TechniqueRow* row = findTechnique(technique))
            numbers.update(searchJson(*row, m_parameters));
        Json relief = {{"heightTexture", *texture}};
        relief.update(numbers);
        material["extensions"][kReliefExtension] = relief;
        material["extras"]["relievo"] = numbers;
        m_file.use(kReliefExtension);
        if (m_job.cures.contains(Cure::Bump)) {
            material["extensions"][kBumpExtension] = {{"bumpTexture", *texture}, {"bumpFactor", numbers["depth"]}};
            m_file.use(kBumpExtension);
        }
        m_warnings.push_back({"gltf-height",
            "Viewers that do not know RELIEVO_materials_relief show the normal map only; the height map at 16 bits lies beside the file."});
        if (m_parameters.midlevel < 1.f)
            m_warnings.push_back({"gltf-midlevel",
                "The mesh is written as it is, not pushed out: a reader of the extension must do that for a midlevel below 1."});
        return {};
    }

    GlbFile& m_file;
    const ExportJob& m_job;
    const Parameters& m_parameters;
    const Material& m_material;
    Warnings& m_warnings;
};
} // namespace

Expected<void> addMaterial(GlbFile& file, const ExportJob& job, const Parameters& parameters, Warnings& warnings)
{
    Expected<Json> material = MaterialWriter(file, job, parameters, warnings).write();
    if (!material)
        return tl::unexpected(material.error());
    file.json["materials"] = Json::array({*material});
    if (file.json.contains("textures")) {
        const Json wrap = parameters.wrap == Wrap::Repeat ? 10497 : 33071;
        file.json["samplers"] = Json::array({{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", wrap}, {"wrapT", wrap}}});
    }
    return {};
}

void addPlainMaterial(GlbFile& file, const Parameters& parameters)
{
    file.json["materials"].push_back({{"name", "plain"},
        {"pbrMetallicRoughness",
            {{"baseColorFactor", tinted(parameters, kColorWithoutMap)}, {"roughnessFactor", shortest(parameters.roughness)},
                {"metallicFactor", 0.f}}}});
}

} // namespace relievo
