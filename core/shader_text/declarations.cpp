// What a shader text mentions, and the uniforms and samplers that it therefore has to declare.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/acceleration_map.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include <cctype>

namespace relievo {

namespace {
bool isWordCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

constexpr std::string_view typeName(const Member& member)
{
    constexpr std::array<std::string_view, 4> names = {"float", "int", "bool", "vec3"};
    return member.index() < names.size() ? names[member.index()] : "int"; // of a choice
}
constexpr std::string_view typeName(const SceneMember& member)
{
    constexpr std::array<std::string_view, 6> names = {"float", "vec2", "vec3", "mat2", "mat4", "mat4"};
    return names[member.index()];
}
} // namespace

bool mentionsIdentifier(std::string_view text, std::string_view identifier)
{
    for (std::size_t at = text.find(identifier); at != text.npos; at = text.find(identifier, at + 1)) {
        const std::size_t end = at + identifier.size();
        const bool starts = at == 0 || (!isWordCharacter(text[at - 1]) && text[at - 1] != '.');
        if (starts && (end == text.size() || !isWordCharacter(text[end])))
            return true;
    }
    return false;
}

std::string uniformDeclarations(const std::string& text)
{
    std::string declarations;
    const auto declare = [&](std::string_view type, std::string_view name) {
        if (mentionsIdentifier(text, name))
            declarations += "uniform " + std::string(type) + ' ' + std::string(name) + ";\n";
    };
    for (const ParameterRow& row : kParameters)
        declare(typeName(row.member), row.key);
    for (const SceneUniformRow& row : kSceneUniforms)
        if (!std::holds_alternative<std::array<glm::mat4, kMostLights> SceneUniforms::*>(row.member))
            declare(typeName(row.member), row.name);
        else if (mentionsIdentifier(text, row.name))
            declarations += "uniform mat4 " + std::string(row.name) + '[' + std::to_string(kMostLights) + "];\n";
    for (const MapKindRow& row : kMapKinds) {
        declare("sampler2D", std::string(row.key) + "Map");
        declare("float", std::string(row.key) + "MapLevels"); // log2 of the map's longest side
    }
    declare("float", "heightMapLast"); // its last mip level
    declare("sampler2D", "boundMap"); // of the technique, by what it is: filtered or heights, codes, a volume
    for (const char* map : {"boundHighMap", "boundLowMap", "ormMap"}) // see exportedForLoaders
        declare("sampler2D", map);
    declare("float", "ormMapLevels");
    declare("usampler2D", "cellMap");
    declare("sampler3D", "distanceMap");
    if (mentionsIdentifier(text, "boundScales"))
        declarations += "uniform vec4 boundScales[" + std::to_string(kMaxHeightLevels) + "];\n";
    declare("sampler2D", "slopeMap"); // dh/du and dh/dv of the height map, per tile
    declare("float", "slopeMapLevels");
    declare("sampler2DArray", "horizonMap"); // see horizon/horizons.glsl
    declare("float", "horizonMapLevels");
    declare("samplerBuffer", "objectMap"); // of a relief object, see object/object_contract.glsl
    if (mentionsIdentifier(text, "objectAxes"))
        declarations += "uniform ivec4 objectAxes[3];\nuniform int objectLevels[48];\n";
    declare("sampler2DArray", "objectColorMap"); // of its sides
    declare("sampler2DArray", "objectNormalMap"); // alpha: roughness
    declare("float", "objectMapLevels");
    declare("samplerBuffer", "borderMap");
    declare("samplerBuffer", "prismMap"); // see view_ray/prisms.glsl
    declare("sampler2D", "prismImage"); // the same where there are no buffers
    declare("float", "firstTriangle"); // that is drawn, of those in these maps
    declare("samplerCube", "environmentMap");
    declare("sampler2D", "exactMap"); // distances of the displaced mesh, m, negative: unknown; and how uncertain they are
    declare("sampler2DShadow", "shadowMap");
    declare("samplerBuffer", "poseMap"); // see vertex/place_posed.glsl
    declare("samplerBuffer", "morphMap");
    declare("float", "heightUnits"); // see heights/stored_exact.glsl
    declare("float", "boundUnits");
    declare("sampler2D", "rayMap");
    declare("sampler2D", "wayMap");
    declare("sampler2D", "cosineMap");
    return declarations;
}

} // namespace relievo
