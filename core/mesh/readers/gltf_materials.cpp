// glTF materials as map slots: metallic-roughness, and the older specular-glossiness.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/gltf_materials.h"
#include "core/gltf/gltf_document.h"
#include "core/gltf/gltf_extensions.h"
#include "core/gltf/gltf_layers.h"
#include "core/gltf/gltf_uri.h"
#include "core/gltf/gltf_values.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/mesh/readers/gltf_not_shown.h"
#include "core/state/parameters.h"
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace relievo {
namespace fs = std::filesystem;

namespace {
// What a material says about one texture.
struct Texture {
    int index = -1;
    TextureSpace space;
};

double element(const tinygltf::Value& list, int i, double otherwise)
{
    return list.IsArray() && std::size_t(i) < list.ArrayLen() ? numberOf(list.Get(i), otherwise) : otherwise;
}

// KHR_texture_transform: scaled, then turned counter-clockwise as seen with v down, then shifted.
TextureSpace spaceOf(int set, const tinygltf::Value& transform)
{
    TextureSpace space;
    space.set = std::clamp(indexOf(member(transform, "texCoord"), set), 0, 99);
    if (!transform.IsObject())
        return space;
    const double angle = numberOf(member(transform, "rotation"), 0.0), c = std::cos(angle), s = std::sin(angle);
    const tinygltf::Value &scale = member(transform, "scale"), &offset = member(transform, "offset");
    const glm::vec2 size(element(scale, 0, 1.0), element(scale, 1, 1.0));
    space.uvFromSet
        = glm::mat3x2(glm::vec2(c, -s) * size.x, glm::vec2(s, c) * size.y, glm::vec2(element(offset, 0, 0.0), element(offset, 1, 0.0)));
    return space;
}

template <class Info> Texture textureOf(const Info& info)
{
    const auto transform = info.extensions.find(kTransformExtension);
    return {info.index, spaceOf(info.texCoord, transform == info.extensions.end() ? tinygltf::Value() : transform->second)};
}

Texture textureIn(const tinygltf::Value& extension, const char* key)
{
    const tinygltf::Value& info = member(extension, key);
    return {indexOf(member(info, "index"), -1),
        spaceOf(indexOf(member(info, "texCoord"), 0), member(member(info, "extensions"), kTransformExtension))};
}

class MaterialReader {
public:
    MaterialReader(const tinygltf::Model& model, const fs::path& file) : m_model(model), m_file(file) { }

    GltfMaterials read()
    {
        for (const tinygltf::Material& material : m_model.materials)
            readOne(material);
        return std::move(m_read);
    }

private:
    std::string uniqueName(const std::string& given)
    {
        const std::string base = given.empty() ? "material " + std::to_string(m_read.materials.size()) : given;
        std::string name = base;
        int& number = m_lastNumber.try_emplace(base, 1).first->second;
        while (!m_names.insert(name).second)
            name = base + " (" + std::to_string(++number) + ')';
        return name;
    }

    void readOne(const tinygltf::Material& material)
    {
        m_material = {uniqueName(material.name), {}};
        m_space.reset();
        m_firstTexture = -1;
        m_setsDiffer = m_transformsDiffer = false;
        const auto& pbr = material.pbrMetallicRoughness;
        const auto older = material.extensions.find(kSpecularGlossinessExtension);
        const bool hasOlder = older != material.extensions.end();
        const Texture color
            = hasOlder && pbr.baseColorTexture.index < 0 ? textureIn(older->second, "diffuseTexture") : textureOf(pbr.baseColorTexture);
        put(MapKind::Color, color);
        if (material.alphaMode == "MASK" || material.alphaMode == "BLEND")
            putAlpha(MapKind::Opacity, color);
        put(MapKind::Normal, textureOf(material.normalTexture));
        put(MapKind::Roughness, textureOf(pbr.metallicRoughnessTexture), Channel::G);
        put(MapKind::Metallic, textureOf(pbr.metallicRoughnessTexture), Channel::B);
        if (hasOlder) {
            put(MapKind::Specular, textureIn(older->second, "specularGlossinessTexture"));
            putAlpha(MapKind::Gloss, textureIn(older->second, "specularGlossinessTexture"));
        }
        put(MapKind::AmbientOcclusion, textureOf(material.occlusionTexture), Channel::R);
        put(MapKind::Emission, textureOf(material.emissiveTexture));
        readRelief(material);
        readBump(material);
        readFactors(material);
        tellSpace();
        m_read.materials.push_back(std::move(m_material));
        m_read.spaces.push_back(m_space.value_or(TextureSpace()));
    }

    void readFactors(const tinygltf::Material& material)
    {
        const auto& pbr = material.pbrMetallicRoughness;
        const auto channel = [](const std::vector<double>& values, std::size_t i, double otherwise) {
            return float(i < values.size() ? values[i] : otherwise);
        };
        MeshFactors factors;
        factors.clamped = wrapOf(m_model, m_firstTexture) == GltfWrap::Clamp;
        float brightest = 0.f;
        for (int i = 0; i < 3; ++i) {
            factors.color[i] = channel(pbr.baseColorFactor, std::size_t(i), 1.0);
            brightest = std::max(brightest, channel(material.emissiveFactor, std::size_t(i), 0.0));
        }
        factors.roughness = float(pbr.roughnessFactor), factors.metallic = float(pbr.metallicFactor);
        if (isSpecularGlossiness(material))
            takeOlderFactors(material.extensions.at(kSpecularGlossinessExtension), factors);
        factors.normal = float(material.normalTexture.scale), factors.occlusion = float(material.occlusionTexture.strength);
        const auto brighter = material.extensions.find(kBrighterExtension);
        factors.emission
            = brightest * float(brighter == material.extensions.end() ? 1.0 : numberOf(member(brighter->second, "emissiveStrength"), 1.0));
        readLayers(material, factors);
        m_material.factors = factors;
    }

    // How far the texture's u is turned from the UV set's, degrees counter-clockwise as seen.
    float textureTurn() const
    {
        const TextureSpace space = m_space.value_or(TextureSpace());
        const glm::vec2 u = glm::inverse(glm::mat2(space.uvFromSet[0], space.uvFromSet[1])) * glm::vec2(1.f, 0.f);
        const float turn = glm::degrees(std::atan2(-u.y, u.x));
        return std::isfinite(turn) ? turn : 0.f;
    }

    void readLayers(const tinygltf::Material& material, MeshFactors& factors) const
    {
        for (const GltfLayerRow& row : kGltfLayers)
            if (const auto found = material.extensions.find(row.extension); found != material.extensions.end())
                factors.layers.emplace_back(kParameters[indexOf(row.member)].key,
                    float(numberOf(member(found->second, row.factor), double(row.without))) / row.unit);
        for (auto& [key, value] : factors.layers)
            if (key == kParameters[indexOf(&Parameters::anisotropyRotation)].key)
                value = std::remainder(value - textureTurn(), 360.f);
        if (const auto found = material.extensions.find(kSheenExtension); found != material.extensions.end())
            for (int i = 0; i < 3; ++i)
                factors.sheen[i] = float(std::clamp(element(member(found->second, kSheenColor), i, 0.0), 0.0, 1.0));
    }

    // KHR_materials_pbrSpecularGlossiness. A gloss map is shown as it is: roughness multiplies 1 - gloss, which no factor of gloss does.
    void takeOlderFactors(const tinygltf::Value& older, MeshFactors& factors)
    {
        const tinygltf::Value &diffuse = member(older, "diffuseFactor"), &specular = member(older, "specularFactor");
        float strength = 0.f;
        for (int i = 0; i < 3; ++i) {
            factors.color[i] = float(element(diffuse, i, 1.0));
            strength = std::max(strength, float(element(specular, i, 1.0)));
        }
        const double gloss = numberOf(member(older, "glossinessFactor"), 1.0);
        const bool hasMap = !m_material.maps[std::size_t(MapKind::Gloss)].empty();
        factors.roughness = hasMap ? 1.f : float(1.0 - std::clamp(gloss, 0.0, 1.0));
        factors.metallic = 0.f;
        factors.specular = strength;
        if (hasMap && gloss != 1.0)
            m_read.warnings.push_back(
                {"gloss-factor", "The material \"" + m_material.name + "\" multiplies its gloss map by a factor, which is not followed."});
    }

    // Our own extension: what an export of this program wrote is read again.
    void readRelief(const tinygltf::Material& material)
    {
        const auto found = material.extensions.find(kReliefExtension);
        if (found == material.extensions.end())
            return;
        const tinygltf::Value& extension = found->second;
        put(MapKind::Height, textureIn(extension, "heightTexture"));
        if (m_material.maps[std::size_t(MapKind::Height)].empty())
            return;
        constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();
        MeshRelief relief{numberOf(member(extension, "depth"), kNotTold), numberOf(member(extension, "midlevel"), 1.0), {}, {}};
        if (const tinygltf::Value& technique = member(extension, "technique"); technique.IsString())
            relief.technique = technique.Get<std::string>();
        for (const ParameterRow& row : kParameters) {
            const tinygltf::Value& value = member(extension, std::string(row.key).c_str());
            if (row.affects.contains(Affects::Search) && value.IsBool())
                relief.search.emplace_back(row.key, value.Get<bool>() ? 1.0 : 0.0);
            else if (row.affects.contains(Affects::Search) && value.IsNumber())
                relief.search.emplace_back(row.key, value.GetNumberAsDouble());
        }
        m_material.relief = std::move(relief);
    }

    // The heights of other programs, or of ours where only this extension is left; how deep they are nobody told.
    void readBump(const tinygltf::Material& material)
    {
        const auto found = material.extensions.find(kBumpExtension);
        if (found != material.extensions.end() && m_material.maps[std::size_t(MapKind::Height)].empty())
            put(MapKind::Height, textureIn(found->second, "bumpTexture"), Channel::R);
    }

    void tellSpace()
    {
        const std::string name = "The material \"" + m_material.name + "\" ";
        if (m_setsDiffer)
            m_read.warnings.push_back({"uv-sets", name + "maps its pictures by several UV sets; one is used for all."});
        if (m_transformsDiffer)
            m_read.warnings.push_back({"texture-transforms",
                name
                    + "scales, turns or shifts its pictures differently; all follow the first of base color, normal, roughness, specular, "
                      "occlusion, emission and height that it has."});
    }

    void put(MapKind kind, const Texture& texture, Channel channel = Channel::Rgb)
    {
        if (texture.index < 0)
            return;
        if (!m_space)
            m_space = texture.space, m_firstTexture = texture.index;
        m_setsDiffer |= m_space->set != texture.space.set;
        m_transformsDiffer |= m_space->uvFromSet != texture.space.uvFromSet;
        if (const std::optional<std::string> file = pictureOf(texture.index))
            m_material.maps[std::size_t(kind)] = {*file, channel, false};
    }

    // A picture without alpha is opaque everywhere: there is no map to read. One that cannot be read is told when it is loaded.
    void putAlpha(MapKind kind, const Texture& texture)
    {
        put(kind, texture, Channel::A);
        MapSlot& slot = m_material.maps[std::size_t(kind)];
        if (slot.empty())
            return;
        const auto [known, isNew] = m_opaque.try_emplace(slot.file, false);
        if (isNew) {
            const Expected<ImageInfo> info = readImageInfo(slot.file);
            known->second = info && info->channels % 2 == 1;
        }
        if (known->second)
            slot = {};
    }

    std::optional<std::string> missing(const std::string& what)
    {
        const Warning warning{"map-missing", "The material \"" + m_material.name + "\" names " + what};
        if (m_told.insert(warning.text).second)
            m_read.warnings.push_back(warning);
        return std::nullopt;
    }

    // The picture of a texture as a map slot names it.
    std::optional<std::string> pictureOf(int index)
    {
        if (std::size_t(index) >= m_model.textures.size())
            return missing("the texture " + std::to_string(index) + ", which the file does not hold.");
        const tinygltf::Texture& texture = m_model.textures[std::size_t(index)];
        int source = texture.source;
        if (const auto webp = texture.extensions.find("EXT_texture_webp"); source < 0 && webp != texture.extensions.end())
            source = indexOf(member(webp->second, "source"), -1);
        if (source < 0 && texture.extensions.contains("KHR_texture_basisu"))
            return missing("a KTX2 picture, which is not read; export it as PNG.");
        if (source < 0 || std::size_t(source) >= m_model.images.size())
            return missing("a picture that the file does not hold.");
        const tinygltf::Image& image = m_model.images[std::size_t(source)];
        if (holdsPicture(m_model, image))
            return embeddedPictureName(m_file, source);
        if (image.uri.empty())
            return missing("a picture that the file does not hold.");
        const std::string name = percentDecoded(image.uri);
        const std::optional<fs::path> found = findPicture({absolutePath(m_file).parent_path()}, name);
        return found ? found->string() : missing("the picture " + shownName(name) + ", which is not there; put it beside the mesh.");
    }

    const tinygltf::Model& m_model;
    const fs::path& m_file;
    GltfMaterials m_read;
    std::set<std::string> m_names, m_told; // of materials, and texts of warnings
    std::map<std::string, bool> m_opaque; // pictures whose alpha was asked for: whether they have none
    std::map<std::string, int> m_lastNumber; // behind the names that several materials share
    MeshMaterial m_material; // the one at work, its space and whether its pictures agree on it
    std::optional<TextureSpace> m_space;
    int m_firstTexture = -1; // whose space that is
    bool m_setsDiffer = false, m_transformsDiffer = false;
};
} // namespace

GltfMaterials readMaterials(const tinygltf::Model& model, const fs::path& file)
{
    return MaterialReader(model, file).read();
}

} // namespace relievo
