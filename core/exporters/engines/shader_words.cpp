// Shaders that are exported: put together as the renderer's own, each uniform told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/shader_words.h"
#include "core/exporters/map_images.h"
#include "core/exporters/uniform_values.h"
#include "core/maps/maps.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/shader_text/translate.h"
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
        told << std::exp2(source.parameters.exposure) << ", times the white balance";
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

// The list of uniforms as comments, and the text.
std::string withUniformsListed(const std::string& translated, const std::string& told)
{
    std::string list = std::string(kLicence) + "// Uniforms, textures and what they hold here:\n";
    std::istringstream lines(told);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("uniform "))
            list += "//     " + line.substr(line.find(' ') + 1) + '\n';
    return list + translated;
}

// Both stages of the words that addProgram made for GLSL 4.10.
Expected<void> addTranslated(Words& words, const std::string& name, ShadingLanguage language)
{
    for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
        const std::string word = stage == Stage::Vertex ? "vertex" : "fragment";
        const std::string& told = words.at(word + "410");
        const Expected<std::string> text = translated(told, stage, language);
        if (!text)
            return tl::unexpected(text.error());
        words[word + name] = withUniformsListed(*text, told);
    }
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

// The text with the scale of the one level that is searched as a constant: arrays of uniforms are not to be had everywhere.
std::string withScale(const std::string& text, glm::vec4 scale)
{
    std::ostringstream constant;
    constant.precision(9);
    constant << std::showpoint << "vec4(" << scale.x << ", " << scale.y << ", " << scale.z << ", " << scale.w << ")";
    return std::regex_replace(text, std::regex(R"(boundScales\[searchLevel\(\)\])"), constant.str());
}

// What `trace` needs as Godot's shading language has it: no global variables.
Expected<void> addGodot(Words& words, const Source& source)
{
    Expected<std::string> text = searchForGodot(source.technique, source.parameters.wrap == Wrap::Clamp, embeddedReader());
    const Expected<glm::vec4> scale = boundScaleOf(source);
    if (!text || !scale)
        return tl::unexpected(!text ? text.error() : scale.error());
    std::string out = std::regex_replace(withScale(*text, *scale), std::regex(R"(\n[^\n]*gaveUp = [^\n]*)"), "");
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

// {name: [type, value]} of the uniforms that `text` declares, but textures and what the engine itself tells.
std::string uniformsAsScript(const std::string& text, const Source& source)
{
    static const std::regex uniform(R"(\nuniform (float|int|bool|vec[234]|mat2) (\w+);)");
    Parameters written = source.parameters;
    written.depth *= source.heights.span;
    written.midlevel = source.heights.midlevel(source.parameters);
    WebJson values = uniformValues(written, source.technique, source.job);
    values["heightUnits"] = 65535;
    std::string script = "{\n";
    for (std::sregex_iterator found(text.begin(), text.end(), uniform), end; found != end; ++found)
        if (const std::string name = (*found)[2]; name != "eye" && values.contains(name))
            script += "  " + name + ": " + WebJson{(*found)[1].str(), values[name]}.dump() + ",\n";
    return script + "}";
}

Expected<void> addForLoaders(TemplateValues& values, const Source& source)
{
    const auto program = meshProgram(exportedForLoaders(source.parameters, source.technique, mapsOf(source)), embeddedReader());
    const Expected<glm::vec4> scale = boundScaleOf(source);
    if (!program || !scale)
        return tl::unexpected(!program ? program.error() : scale.error());
    std::string fragment
        = std::regex_replace(withScale(program->fragment.text, *scale), std::regex("uniform vec4 boundScales[^\n]*\n"), "");
    fragment = std::string(kLicence) + fragment.substr(fragment.find('\n') + 1); // #version stands first
    std::ranges::replace(fragment, '`', '\''); // of comments: the text stands between such in scripts
    values.words["uniformsLoaders"] = uniformsAsScript(program->vertex.text + fragment, source);
    values.words["fragmentLoaders"] = std::move(fragment);
    values.switches["ownShader"] = true;
    return {};
}

// As HLSL; what the search reads beside textures is written in.
Expected<void> addUnreal(TemplateValues& values, const Source& source)
{
    Expected<std::string> text = searchForUnreal(source.technique, source.parameters.wrap == Wrap::Clamp, embeddedReader());
    const Expected<glm::vec4> scale = boundScaleOf(source);
    if (!text || !scale)
        return tl::unexpected(!text ? text.error() : scale.error());
    std::string glsl = std::regex_replace(withScale(*text, *scale), std::regex(R"(\n[^\n]*gaveUp = [^\n]*)"), "");
    glsl = std::regex_replace(glsl, std::regex("uniform vec4 boundScales[^\n]*\n"), "");
    for (const ParameterRow& row : kParameters) {
        const std::string name(row.key);
        const std::string value = std::visit([](auto is) { return jsonOf(is).dump(); }, get(source.parameters, row));
        glsl = std::regex_replace(glsl, std::regex("uniform (float|int|bool) " + name + ";"), "const $1 " + name + " = $1(" + value + ");");
    }
    const Expected<std::string> search = searchAsStruct(glsl);
    if (!search)
        return tl::unexpected(search.error());
    values.words["searchUnreal"] = *search;
    values.switches["ownShader"] = true;
    return {};
}

constexpr std::string_view kForLoaders = "{{#ownShader}}";

// Why no web engine can search so; "" where it can.
std::string unfitForLoaders(const ExportJob& job)
{
    const TechniqueRow* technique = findTechnique(techniqueOf(job));
    if (!technique || technique->file.empty())
        return "this technique has no shader";
    if (technique->needsHeights() && !job.resources.material->height)
        return "it searches heights, and there are none";
    if (!technique->accelerationMap.empty() && findBakedMap(technique->accelerationMap)->form == MapForm::Volume)
        return "it reads a volume, which no picture holds";
    return {};
}
} // namespace

std::string techniqueLeftOut(const TargetText& target, const ExportJob& job)
{
    const std::string why = unfitForLoaders(job);
    if (why.empty()
        || std::ranges::none_of(target.files, [](const TargetFile& file) { return file.text.find(kForLoaders) != file.text.npos; }))
        return {};
    return "The material of this technique is left out: " + why + ". The engine's own is written.";
}

Expected<void> addShaders(
    TemplateValues& values, const std::string& text, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    const auto mentions = [&text](const char* word) { return text.find(word) != text.npos; };
    const bool isTranslated = mentions("Hlsl}}") || mentions("Msl}}"), is410 = isTranslated || mentions("410}}");
    const TechniqueRow* technique = findTechnique(techniqueOf(job));
    if (mentions(kForLoaders.data())) {
        values.switches["ownShader"] = false;
        for (const char* word : {"fragmentLoaders", "uniformsLoaders", "searchUnreal"})
            values.words[word] = {};
        if (!unfitForLoaders(job).empty())
            return {};
        const Source source{job, heights, parameters, *technique};
        return mentions("{{{searchUnreal}}}") ? addUnreal(values, source) : addForLoaders(values, source);
    }
    if (!is410 && !mentions("Es300}}") && !mentions("{{{searchGodot}}}"))
        return {};
    if (!technique || technique->file.empty())
        return failure(techniqueOf(job), "this technique has no shader", "Choose one that draws pictures, such as cell-cone");
    if (technique->needsHeights() && !heights.field)
        return failure(job.state.name, "the material has no height map, which the technique " + std::string(technique->key) + " searches",
            "Open one, or choose bump");
    const Source source{job, heights, parameters, *technique};
    for (const Dialect dialect : {Dialect::Desktop, Dialect::Es})
        if (dialect == Dialect::Es ? mentions("Es300}}") : is410)
            if (auto added = addProgram(values.words, dialect, source); !added)
                return added;
    for (const auto& [name, language] : {std::pair("Hlsl", ShadingLanguage::Hlsl), std::pair("Msl", ShadingLanguage::Msl)})
        if (mentions((std::string(name) + "}}").c_str()))
            if (auto added = addTranslated(values.words, name, language); !added)
                return added;
    return mentions("{{{searchGodot}}}") ? addGodot(values.words, source) : Expected<void>();
}

} // namespace relievo
