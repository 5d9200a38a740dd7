// Materials of Babylon.js, PlayCanvas and O3DE, which are JSON.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/json_depth.h"
#include "core/scene/materials/material_fields.h"
#include <nlohmann/json.hpp>

namespace relievo {
using nlohmann::json;

namespace {
void flatten(MaterialFields& fields, const std::string& key, const json& value)
{
    if (value.is_object() || value.is_array()) {
        int index = 0;
        for (const auto& [member, part] : value.items())
            flatten(fields, key.empty() ? member : key + '.' + (value.is_array() ? std::to_string(index++) : member), part);
    } else if (value.is_string()) {
        fields[key] = value.get<std::string>();
    } else if (!value.is_null()) {
        fields[key] = value.dump();
    }
}

MaterialFields flat(const json& material, const char* type)
{
    MaterialFields fields;
    flatten(fields, "", material);
    if (const auto name = material.find("name"); name != material.end() && name->is_string())
        fields["$name"] = name->get<std::string>();
    fields["$type"] = type;
    return fields;
}

bool has(const json& object, const char* key)
{
    return object.is_object() && object.contains(key);
}

// Babylon.js writes a texture as an object: its file is "url", or else "name".
MaterialFields babylon(const json& material)
{
    MaterialFields fields = flat(material, "babylon");
    for (const auto& [key, value] : material.items())
        if (value.is_object())
            for (const char* member : {"name", "url"})
                if (const auto file = value.find(member); file != value.end() && file->is_string() && !file->get<std::string>().empty())
                    fields[key] = file->get<std::string>();
    return fields;
}

bool isBabylon(const json& material)
{
    return has(material, "useParallax") || has(material, "parallaxScaleBias") || has(material, "bumpTexture")
        || has(material, "albedoTexture") || has(material, "diffuseTexture");
}

bool isPlayCanvas(const json& material)
{
    return has(material, "heightMap") || has(material, "heightMapFactor") || has(material, "diffuseMap") || has(material, "normalMap");
}
} // namespace

Expected<MaterialFields> readJsonMaterial(std::string_view text, const std::filesystem::path& file)
{
    const json document = isNestedTooDeep(text) ? json() : json::parse(text, nullptr, false);
    if (document.is_discarded() || !document.is_object())
        return failure(ErrorCode::Unreadable, file.string(), "this is no JSON that can be read", "Export the material again");
    if (has(document, "propertyValues") && document["propertyValues"].is_object())
        return flat(document["propertyValues"], "o3de");
    if (has(document, "materialType") && has(document, "properties") && document["properties"].is_object())
        return flat(document["properties"], "o3de");
    if (has(document, "materials") && document["materials"].is_array()) { // a scene of Babylon.js
        const json* first = nullptr;
        for (const json& material : document["materials"])
            if (isBabylon(material) && (!first || (!has(*first, "useParallax") && has(material, "useParallax"))))
                first = &material;
        if (first)
            return babylon(*first);
    }
    if (isBabylon(document))
        return babylon(document);
    const bool isAsset = has(document, "data") && document["data"].is_object();
    if (isPlayCanvas(isAsset ? document["data"] : document)) {
        MaterialFields fields = flat(isAsset ? document["data"] : document, "playcanvas");
        if (isAsset && has(document, "name") && document["name"].is_string())
            fields["$name"] = document["name"].get<std::string>();
        return fields;
    }
    return failure(file.string(), "no material of Babylon.js, PlayCanvas or O3DE was found in it",
        "Presets are applied to an open material, and textures opened by their folder");
}

} // namespace relievo
