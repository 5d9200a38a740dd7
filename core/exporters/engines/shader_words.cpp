// Shaders that are exported: put together as the renderer's own, each uniform told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/shader_words.h"
#include "core/exporters/map_images.h"
#include "core/maps/maps.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include <cmath>
#include <regex>
#include <sstream>

namespace relievo {
namespace {

constexpr std::string_view kLicence = "// Written by Relievo. SPDX-License-Identifier: MIT\n";

struct Source {
    const ExportJob& job;
    const WrittenHeights& heights;
    const Parameters& parameters;
    const TechniqueRow& technique;
};

// The scale of the technique's acceleration map, as the search multiplies by it.
Expected<glm::vec4> boundScaleOf(const Source& source)
{
    if (source.technique.accelerationMap.empty() || !source.heights.field)
        return glm::vec4(1.f);
    const auto map
        = cachedMap(*findBakedMap(source.technique.accelerationMap), *source.heights.field, source.parameters, source.job.progress);
    if (!map)
        return tl::unexpected(map.error());
    return (*map)->scale;
}

// What stands behind a uniform's declaration: the value here, or what it is.
std::string toldOf(const std::string& name, const Source& source, glm::vec4 boundScale)
{
    for (const ParameterRow& row : kParameters)
        if (name == row.key)
            return toText(row, get(source.parameters, row)) + (row.unit.empty() ? "" : " " + std::string(row.unit)) + ": "
                + std::string(row.label);
    std::ostringstream told;
    const float unit = source.job.resources.mesh->metresPerUV;
    if (name == "reliefDepth")
        told << physicalDepth(source.parameters, unit) * source.heights.span << " m: black to white";
    else if (name == "pushOut")
        told << (1.f - source.heights.midlevel(source.parameters)) * physicalDepth(source.parameters, unit) * source.heights.span
             << " m: the mesh is pushed out by this, so that height " << source.heights.midlevel(source.parameters) << " lies on it";
    else if (name == "boundScales")
        told << "the first: " << boundScale.x << ", " << boundScale.y << ", " << boundScale.z << ", " << boundScale.w;
    else if (name == "heightUnits" || name == "boundUnits")
        told << "65535 where the texture holds whole numbers of 16 bits, 0 where it holds floats";
    else if (name == "eye")
        told << "of the camera, m, world space";
    else if (name == "lightDirection")
        told << "unit, towards the light, world space";
    else if (name == "exposureFactor")
        told << std::exp2(source.parameters.exposure);
    else if (name == "textureFromMesh")
        told << "the material's turn and tiling " << source.parameters.tiling;
    else if (name == "textureShift")
        told << source.parameters.offsetU << ", " << source.parameters.offsetV;
    else if (name.ends_with("MapLevels"))
        told << "log2 of the longest side of that texture";
    else if (name.ends_with("Map"))
        told << "linear, repeated" << (name == "colorMap" || name == "emissionMap" ? "; sRGB" : "");
    return told.str();
}

std::string withUniformsTold(const std::string& text, const Source& source, glm::vec4 boundScale)
{
    static const std::regex uniform(R"(^uniform [a-zA-Z0-9]+ ([a-zA-Z0-9]+)(\[[0-9]+\])?;$)");
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line); out += line + '\n')
        if (std::smatch found; std::regex_match(line, found, uniform))
            if (const std::string told = toldOf(found[1], source, boundScale); !told.empty())
                line += " // " + told;
    const std::size_t body = out.find('\n') + 1; // #version stands first
    return out.insert(body, kLicence);
}

// With the normals that are made where there are none.
EnumSet<MapKind> mapsOf(const Source& source)
{
    EnumSet<MapKind> maps = presentMaps(*source.job.resources.material);
    if (source.heights.field && source.job.cures.contains(Cure::Normals))
        maps.insert(MapKind::Normal);
    return maps;
}

Expected<void> addProgram(Words& words, Dialect dialect, const Source& source)
{
    const auto program = meshProgram(exportedFeatures(source.parameters, source.technique, mapsOf(source), dialect), embeddedReader());
    if (!program)
        return tl::unexpected(program.error());
    const Expected<glm::vec4> scale = boundScaleOf(source);
    if (!scale)
        return tl::unexpected(scale.error());
    const std::string name = dialect == Dialect::Es ? "Es300" : "410";
    words["vertex" + name] = withUniformsTold(program->vertex.text, source, *scale);
    words["fragment" + name] = withUniformsTold(program->fragment.text, source, *scale);
    return {};
}
// A parameter as Godot declares it, with this State's value as default.
std::string godotUniform(const ParameterRow& row, const Parameters& parameters)
{
    const Value value = get(parameters, row);
    const std::string name = " " + std::string(row.key), is = " = " + toText(row, value) + ";\n";
    if (std::holds_alternative<bool>(value))
        return "uniform bool" + name + is;
    std::ostringstream range;
    range << " : hint_range(" << row.min << ", " << row.max << ")";
    return (std::holds_alternative<int>(value) ? "uniform int" : "uniform float") + name + range.str() + is;
}

// What `trace` needs as Godot's shading language has it: no global variables, no arrays of uniforms.
Expected<void> addGodot(Words& words, const Source& source)
{
    Expected<std::string> text = searchForGodot(source.technique, source.parameters.wrap == Wrap::Clamp, embeddedReader());
    const Expected<glm::vec4> scale = boundScaleOf(source);
    if (!text || !scale)
        return tl::unexpected(!text ? text.error() : scale.error());
    std::ostringstream constant;
    constant.precision(9);
    constant << std::showpoint << "vec4(" << scale->x << ", " << scale->y << ", " << scale->z << ", " << scale->w << ")";
    std::string out = std::regex_replace(*text, std::regex(R"(boundScales\[searchLevel\(\)\])"), constant.str());
    out = std::regex_replace(out, std::regex(R"(\n[^\n]*gaveUp = [^\n]*)"), "");
    const std::string bare = withoutComments(out);
    const std::string options = source.parameters.wrap == Wrap::Clamp ? "repeat_disable" : "repeat_enable";
    std::string uniforms;
    for (const char* map : {"heightMap", "boundMap"})
        if (mentionsIdentifier(bare, map))
            uniforms += std::string("uniform sampler2D ") + map + " : filter_linear, " + options + ";\n";
    for (const char* map : {"boundHighMap", "boundLowMap"})
        if (mentionsIdentifier(bare, map))
            uniforms += std::string("uniform sampler2D ") + map + " : filter_nearest, " + options + ";\n";
    for (const ParameterRow& row : kParameters)
        if (row.group == Group::Search && mentionsIdentifier(bare, row.key))
            uniforms += godotUniform(row, source.parameters);
    words["searchGodot"] = uniforms + out;
    return {};
}
} // namespace

Expected<void> addShaders(
    TemplateValues& values, const std::string& text, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    const auto mentions = [&text](const char* word) { return text.find(word) != text.npos; };
    if (!mentions("410}}") && !mentions("Es300}}") && !mentions("{{{searchGodot}}}"))
        return {};
    const TechniqueRow* technique = findTechnique(techniqueOf(job));
    if (!technique || technique->file.empty())
        return failure(techniqueOf(job), "this technique has no shader", "Choose one that draws pictures, such as cell-cone");
    if (technique->needsHeights() && !heights.field)
        return failure(job.state.name, "the material has no height map, which the technique " + std::string(technique->key) + " searches",
            "Open one, or choose bump");
    const Source source{job, heights, parameters, *technique};
    for (const Dialect dialect : {Dialect::Desktop, Dialect::Es})
        if (mentions(dialect == Dialect::Es ? "Es300}}" : "410}}"))
            if (auto added = addProgram(values.words, dialect, source); !added)
                return added;
    return mentions("{{{searchGodot}}}") ? addGodot(values.words, source) : Expected<void>();
}

} // namespace relievo
