// The table of material extensions that are not followed, and other losses.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/gltf_not_shown.h"
#include "core/gltf/gltf_extensions.h"
#include "core/gltf/gltf_values.h"
#include "core/gltf/pictures.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace relievo {
namespace {
struct ExtensionRow {
    std::string_view name, words; // "" where it is followed
    const char* factor = nullptr; // without effect where this number is `none`
    double none = 0;
};
constexpr auto kExtensions = std::to_array<ExtensionRow>({
    {kReliefExtension, ""},
    {kBumpExtension, ""},
    {kBrighterExtension, ""},
    {kSpecularGlossinessExtension, ""},
    {"KHR_materials_unlit", "unlit materials"},
    {"KHR_materials_clearcoat", ""},
    {"KHR_materials_transmission", ""},
    {"KHR_materials_diffuse_transmission", "diffuse transmission", "diffuseTransmissionFactor"},
    {"KHR_materials_volume", "volume", "thicknessFactor"},
    {"KHR_materials_ior", ""},
    {"KHR_materials_sheen", ""},
    {"KHR_materials_specular", "specular strength"},
    {"KHR_materials_iridescence", "iridescence", "iridescenceFactor"},
    {"KHR_materials_anisotropy", ""},
    {"KHR_materials_dispersion", "dispersion", "dispersion"},
    {"KHR_materials_variants", "material variants"},
});

// What is missing, each once, in the order of its finding.
class Losses {
public:
    void add(const std::string& words)
    {
        if (!words.empty() && std::ranges::find(m_words, words) == m_words.end())
            m_words.push_back(words);
    }
    std::optional<Warning> told() const
    {
        if (m_words.empty())
            return std::nullopt;
        std::string text = "Not shown: ";
        for (const std::string& words : m_words)
            text += (&words == &m_words.front() ? "" : ", ") + words;
        return Warning{"not-shown", text + "."};
    }

private:
    std::vector<std::string> m_words;
};

void addExtension(const std::string& name, const tinygltf::Value& value, Losses& losses)
{
    const auto row = std::ranges::find(kExtensions, name, &ExtensionRow::name);
    if (row == kExtensions.end())
        return losses.add("the extension " + shownName(name));
    if (row->words.empty() && name.starts_with("KHR_materials_") && name != kSpecularGlossinessExtension && value.IsObject())
        for (const std::string& key : value.Keys()) // the numbers are followed, pictures are not
            if (key.ends_with("Texture"))
                losses.add("the picture " + shownName(key));
    const bool inEffect = !row->factor || numberOf(member(value, row->factor), row->none) != row->none;
    if (inEffect)
        losses.add(std::string(row->words));
}

void addWrap(const tinygltf::Model& model, int texture, Losses& losses)
{
    if (wrapOf(model, texture) == GltfWrap::Other)
        losses.add("pictures that are mirrored at their borders or repeat in one direction only");
}

void addMaterial(const tinygltf::Model& model, const tinygltf::Material& material, Losses& losses)
{
    for (const auto& [name, value] : material.extensions)
        addExtension(name, value, losses);
    const auto& pbr = material.pbrMetallicRoughness;
    for (const int texture : {pbr.baseColorTexture.index, pbr.metallicRoughnessTexture.index, material.normalTexture.index,
             material.occlusionTexture.index, material.emissiveTexture.index})
        addWrap(model, texture, losses);
    if (isSpecularGlossiness(material))
        losses.add("specular colors but in Blinn-Phong shading");
    if (material.alphaMode != "OPAQUE" && pbr.baseColorFactor.size() > 3 && pbr.baseColorFactor[3] < 1.0)
        losses.add("transparency");
    const std::vector<double>& light = material.emissiveFactor;
    const bool shines = std::ranges::any_of(light, [](double channel) { return channel > 0; });
    if (shines && material.emissiveTexture.index < 0)
        losses.add("emission without a picture");
    else if (shines && std::ranges::any_of(light, [&](double channel) { return channel != light.front(); }))
        losses.add("the hue of emission factors");
}
} // namespace

GltfWrap wrapOf(const tinygltf::Model& model, int texture)
{
    const int sampler = texture >= 0 && std::size_t(texture) < model.textures.size() ? model.textures[std::size_t(texture)].sampler : -1;
    if (sampler < 0 || std::size_t(sampler) >= model.samplers.size())
        return GltfWrap::Repeat;
    const tinygltf::Sampler& s = model.samplers[std::size_t(sampler)];
    if (s.wrapS != s.wrapT || s.wrapS == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT)
        return GltfWrap::Other;
    return s.wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ? GltfWrap::Clamp : GltfWrap::Repeat;
}

bool isSpecularGlossiness(const tinygltf::Material& material)
{
    const auto& pbr = material.pbrMetallicRoughness;
    return material.extensions.contains(kSpecularGlossinessExtension) && pbr.baseColorTexture.index < 0
        && pbr.metallicRoughnessTexture.index < 0;
}

std::optional<Warning> notShown(const tinygltf::Model& model)
{
    Losses losses;
    for (const tinygltf::Material& material : model.materials)
        addMaterial(model, material, losses);
    for (const tinygltf::Mesh& mesh : model.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (primitive.attributes.contains("COLOR_0"))
                losses.add("vertex colors");
            if (primitive.extensions.contains("KHR_materials_variants"))
                losses.add("material variants");
        }
    return losses.told();
}

} // namespace relievo
