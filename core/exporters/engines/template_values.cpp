// Values by name, and templates filled with them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/template_values.h"
#include "core/exporters/map_images.h"
#include "core/ground/hash.h"
#include "core/ground/srgb.h"
#include "core/ground/text.h"
#include <charconv>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <kainjow/mustache.hpp>
#include <regex>
#include <set>

namespace relievo {
namespace {
namespace mustache = kainjow::mustache;

// The shortest text that reads back as this float, never without a point: engines tell numbers from counts by it.
std::string decimal(float value)
{
    char buffer[64];
    std::string out(buffer, std::to_chars(buffer, buffer + sizeof buffer, value == 0.f ? 0.f : value, std::chars_format::fixed).ptr);
    return out.find('.') == std::string::npos ? out + ".0" : out;
}

// Letters, digits and _ alone, as programs' names want it.
std::string identifierOf(const std::string& name)
{
    std::string identifier;
    for (const char c : name)
        identifier += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
    return identifier.empty() || (identifier[0] >= '0' && identifier[0] <= '9') ? '_' + identifier : identifier;
}

std::string escaped(const std::string& word)
{
    std::string out;
    for (const char c : word) {
        if (c == '"' || c == '\\')
            out += '\\';
        if (static_cast<unsigned char>(c) >= 0x20)
            out += c;
        else
            out += c == '\n' ? "\\n" : c == '\t' ? "\\t" : " ";
    }
    return out;
}

void addDepths(Words& words, const EngineDepth& depth, float midlevel, const Parameters& parameters, float unit)
{
    words["depthMetres"] = decimal(depth.metres);
    words["depthCentimetres"] = decimal(float(double(depth.metres) * 100.));
    words["depthMillimetres"] = decimal(float(double(depth.metres) * 1000.));
    words["depthTiles"] = decimal(depth.tiles);
    words["depthPercent"] = decimal(float(double(depth.tiles) * 100.));
    words["depthUV"] = decimal(depth.tiles / parameters.tiling);
    words["number"] = decimal(depth.number);
    words["midlevel"] = decimal(midlevel);
    const double bias = -double(midlevel) * double(depth.metres); // rounded once: 0.0225, not 0.022499999
    words["biasMetres"] = decimal(float(bias));
    words["biasCentimetres"] = decimal(float(bias * 100.));
    words["pushOutMetres"] = decimal(float((1. - double(midlevel)) * double(depth.metres)));
    words["metresPerUV"] = decimal(unit);
    words["perMetre"] = decimal(1.f / unit); // UV units along a metre
    words["tileMetres"] = decimal(unit / parameters.tiling);
}

void addPlacement(Words& words, const Parameters& p)
{
    words["tiling"] = decimal(p.tiling);
    words["offsetU"] = decimal(p.offsetU);
    words["offsetV"] = decimal(p.offsetV);
    // Where v goes up the same lies elsewhere: w = 1 - v is tiled, turned the other way round and shifted.
    const float turn = glm::radians(p.rotation);
    words["offsetVFlipped"] = decimal(1.f - p.tiling - p.offsetV); // without the turn
    words["offsetUUp"] = decimal(p.offsetU - p.tiling * std::sin(turn));
    words["offsetVUp"] = decimal(1.f - p.offsetV - p.tiling * std::cos(turn));
    words["rotationDegrees"] = decimal(p.rotation);
    words["rotationRadians"] = decimal(turn);
    words["rotationDegreesUp"] = decimal(-p.rotation);
    words["rotationRadiansUp"] = decimal(-turn);
}

void addShading(Words& words, const Parameters& p, const Material& material)
{
    const float color = material.map(MapKind::Color) ? 1.f : kColorWithoutMap;
    const char* const names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        words[std::string("tint") + names[c]] = decimal(p.tint[c]);
        words[std::string("color") + names[c]] = decimal(p.tint[c] * color); // linear
        words[std::string("srgbColor") + names[c]] = decimal(srgbOf(p.tint[c] * color));
    }
    words["normalStrength"] = decimal(p.normalStrength);
    words["roughness"] = decimal(p.roughness);
    words["smoothness"] = decimal(1.f - p.roughness);
    words["metallic"] = decimal(material.map(MapKind::Metallic) ? p.metallic : 0.f);
    words["shadowBias"] = decimal(p.shadowBias);
    words["aoStrength"] = decimal(p.aoStrength);
    words["emission"] = decimal(p.emission);
}

// Notes which names there are none of.
class StrictContext : public mustache::context<std::string> {
public:
    using context::context;
    const mustache::data* get(const std::string& name) const override
    {
        const mustache::data* found = context::get(name);
        if (!found)
            unknown.insert(name);
        return found;
    }
    const mustache::data* get_partial(const std::string& name) const override
    {
        unknown.insert(name);
        return nullptr;
    }
    mutable std::set<std::string> unknown;
};

mustache::data dataOf(const TemplateValues& values, const Words& more)
{
    mustache::data data;
    for (const Words* words : {&values.words, &more})
        for (const auto& [name, word] : *words)
            data.set(name, word);
    for (const auto& [name, on] : values.switches)
        data.set(name, on);
    for (const auto& [key, words] : values.textures) {
        mustache::data texture;
        for (const auto& [name, word] : words)
            texture.set(name, word);
        data.set(key, words.empty() ? mustache::data(false) : texture);
    }
    return data;
}

int lineAt(const std::string& text, std::ptrdiff_t at)
{
    return int(std::count(text.begin(), text.begin() + at, '\n'));
}

// A tag of a section that stands alone on its line takes the line's end with it, also where the section is left out.
std::string withoutTagLines(const std::string& text)
{
    static const std::regex alone(R"((^|\n)[ \t]*(\{\{[#^/][^}]*\}\})[ \t]*(?=\n))");
    std::string out;
    std::size_t at = 0;
    for (std::sregex_iterator found(text.begin(), text.end(), alone), end; found != end; ++found) {
        const std::size_t tag = std::size_t(found->position(2)), before = std::size_t(found->position() + found->length(1));
        if (before > at)
            out.append(text, at, before - at);
        out.append(text, tag, std::size_t(found->length(2)));
        at = std::size_t(found->position() + found->length()) + 1;
    }
    return out + text.substr(std::min(at, text.size()));
}

// Names are looked up where a section is filled in; those of sections that are left out are looked at here.
std::optional<std::pair<std::string, int>> unknownName(const std::string& text, const TemplateValues& values, const Words& more)
{
    static const std::regex tag(R"(\{\{\{?\s*([#^/&!>=]?)\s*([^}]*?)\s*\}?\}\})");
    static const std::set<std::string> ofTextures = {"file", "guid", "bits", "key"};
    for (std::sregex_iterator found(text.begin(), text.end(), tag), end; found != end; ++found) {
        const std::string sign = (*found)[1], name = (*found)[2];
        const std::size_t dot = name.find('.');
        const bool known = sign == "!" || values.words.contains(name) || more.contains(name) || values.switches.contains(name)
            || values.textures.contains(name)
            || (dot != std::string::npos && values.textures.contains(name.substr(0, dot)) && ofTextures.contains(name.substr(dot + 1)));
        if (!known || sign == ">" || sign == "=")
            return std::pair(sign == ">" || sign == "=" ? sign + name : name, lineAt(text, found->position()));
    }
    return std::nullopt;
}
} // namespace

EngineDepth engineDepth(const EngineFacts& engine, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    EngineDepth depth;
    depth.metres = physicalDepth(parameters, job.resources.mesh->metresPerUV) * heights.span;
    depth.tiles = parameters.depth * heights.span;
    const float wanted = engine.factor * (engine.of == DepthOf::Tile ? depth.tiles : depth.metres);
    depth.number = std::clamp(wanted, engine.min, engine.max);
    depth.drawn = wanted > 0.f ? depth.number / wanted : 1.f;
    return depth;
}

TemplateValues valuesOf(const ExportRow& row, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    TemplateValues values;
    Words& words = values.words;
    words["title"] = job.state.name;
    words["name"] = fileStem(job.state.name);
    words["identifier"] = identifierOf(fileStem(job.state.name));
    words["technique"] = techniqueOf(job);
    words["version"] = RELIEVO_VERSION;
    words["guid"] = hexHash(std::string(row.key) + ' ' + job.state.name);
    words["minSteps"] = std::to_string(parameters.minSteps);
    words["maxSteps"] = std::to_string(std::max(parameters.maxSteps, parameters.minSteps));
    words["refineSteps"] = std::to_string(parameters.refineSteps);
    addDepths(words, engineDepth(row.engine, job, heights, parameters), heights.midlevel(parameters), parameters,
        metresPerUV(parameters, job.resources.mesh->metresPerUV));
    addPlacement(words, parameters);
    addShading(words, parameters, *job.resources.material);
    values.switches["repeat"] = parameters.wrap == Wrap::Repeat;
    const TechniqueRow* const technique = findTechnique(words["technique"]);
    values.switches["searches"] = technique && technique->searches;
    values.switches["selfShadow"] = parameters.shadows && technique && technique->searches;
    values.switches["opacityMap"] = job.resources.material->map(MapKind::Opacity) != nullptr;
    values.switches["emissive"] = job.resources.material->map(MapKind::Emission) && parameters.emission > 0.f;
    return values;
}

Expected<std::string> filled(const std::string& text, const TemplateValues& values, const Words& more, const std::string& where, int line)
{
    const auto at = [&where, line](int below) { return where + ':' + std::to_string(line + below); };
    if (const auto unknown = unknownName(text, values, more))
        return failure(at(unknown->second), "{{" + unknown->first + "}} is no value that there is",
            "The manual lists them under \"Targets of your own\"");
    if (const mustache::mustache asWritten(text); !asWritten.is_valid()) {
        const std::string& error = asWritten.error_message();
        std::size_t position = 0;
        if (const std::size_t number = error.rfind(' '); number != std::string::npos)
            std::from_chars(error.data() + number + 1, error.data() + error.size(), position);
        return failure(
            at(lineAt(text, std::ptrdiff_t(std::min(position, text.size())))), lowered(error), "Close each {{#name}} by {{/name}}");
    }
    mustache::mustache renderer(withoutTagLines(text));
    renderer.set_custom_escape(escaped);
    const mustache::data data = dataOf(values, more);
    StrictContext context(&data);
    std::string out = renderer.render(context);
    if (!context.unknown.empty())
        return failure(at(0), "{{" + *context.unknown.begin() + "}} has no value here",
            "Name it inside {{#" + context.unknown.begin()->substr(0, context.unknown.begin()->find('.')) + "}}");
    return out;
}

} // namespace relievo
