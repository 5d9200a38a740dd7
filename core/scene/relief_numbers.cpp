// Reading the numbers of materials and exported reliefs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/relief_numbers.h"
#include "core/ground/file.h"
#include "core/ground/json_depth.h"
#include "core/image/height_repair.h"
#include "core/image/material.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

namespace relievo {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
std::string shortText(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

void takeTechnique(State& state, const std::string& key)
{
    if (const TechniqueRow* technique = findTechnique(key); technique && !technique->file.empty())
        state.panes.front().technique = key;
}

// json members may be missing or of another kind.
double numberOf(const json& object, const char* key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : std::nan("");
}
std::string textOf(const json& object, const char* key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

json numbersIn(const fs::path& folder)
{
    const Expected<std::string> text = readText(folder / "relief.json", std::size_t(64) << 20);
    return text && !isNestedTooDeep(*text) ? json::parse(*text, nullptr, false) : json();
}

// A map of the export lies as the export says. True when it had been read the other way.
bool takeConvention(State& state, const json& map)
{
    const auto kind = map.is_object() ? findMapKind(textOf(map, "kind")) : std::nullopt;
    const std::string convention = kind ? textOf(map, "convention") : "";
    if (!kind || (convention != "height" && convention != "gl"))
        return false;
    MapSlot& slot = state.slots[std::size_t(*kind)];
    return fs::path(slot.file).filename() == textOf(map, "file") && std::exchange(slot.invert, false);
}
} // namespace

void takeNumber(State& state, std::string_view key, double value)
{
    const ParameterRow& row = *findParameter(key);
    std::visit(
        [&](auto member) {
            using T = std::remove_cvref_t<decltype(state.parameters.*member)>;
            if constexpr (std::is_arithmetic_v<T>)
                if (std::isfinite(value))
                    set(state.parameters, row, clamped(row, T(std::clamp(value, double(row.min), double(row.max)))));
        },
        row.member);
}

void takeRelief(State& state, const MeshRelief& relief, double metresPerUV)
{
    takeNumber(state, "depth", relief.depth / metresPerUV);
    takeNumber(state, "midlevel", relief.midlevel);
    for (const auto& [key, value] : relief.search)
        takeNumber(state, key, value);
    takeTechnique(state, relief.technique);
}

void takeFactors(State& state, const MeshFactors& factors, const MapSlots& maps)
{
    const bool hasColor = !maps[std::size_t(MapKind::Color)].empty(), hasEmission = !maps[std::size_t(MapKind::Emission)].empty();
    const glm::vec3 tint = factors.color / (hasColor ? 1.f : kColorWithoutMap);
    const ParameterRow& row = *findParameter("tint");
    set(state.parameters, row, clamped(row, tint));
    takeNumber(state, "roughness", double(factors.roughness));
    takeNumber(state, "metallic", double(factors.metallic));
    takeNumber(state, "normalStrength", double(factors.normal));
    takeNumber(state, "aoStrength", double(factors.occlusion));
    if (hasEmission)
        takeNumber(state, "emission", double(factors.emission));
    if (factors.specular)
        takeNumber(state, "specular", double(*factors.specular));
    for (const auto& [key, value] : factors.layers)
        takeNumber(state, key, double(value));
    if (const float sheen = std::max({factors.sheen.r, factors.sheen.g, factors.sheen.b}); sheen > 0.f) {
        state.parameters.sheen = sheen;
        state.parameters.sheenColor = factors.sheen / sheen;
    }
    state.parameters.wrap = factors.clamped ? Wrap::Clamp : Wrap::Repeat;
}

void takeHeightNumbers(State& state, const Image& image, Warnings& warnings)
{
    const MapSlot& slot = state.slots[std::size_t(MapKind::Height)];
    const std::string file = fs::path(slot.file).filename().string();
    const HeightPixels pixels(image, slot.channel);
    const ScalarTrouble trouble = scalarTrouble(pixels.image(), pixels.channel());
    const bool isSurvey = image.survey && image.survey->texelWidth > 0;
    if (isSurvey) {
        const double tile = image.survey->texelWidth * image.width,
                     relief = (trouble.rescales() ? trouble.high - trouble.low : 1.) * image.survey->metres, depth = relief / tile;
        takeNumber(state, "depth", depth);
        const bool fits = double(state.parameters.depth) >= depth * 0.999;
        warnings.push_back({"survey",
            file + ": " + shortText(relief) + " m of relief on a tile of " + shortText(tile) + " m: a depth of " + shortText(depth)
                + " tiles" + (fits ? "" : ", more than the " + shortText(double(state.parameters.depth)) + " that can be shown")});
    } else if (const std::optional<double> zero = trouble.zero()) {
        takeNumber(state, "midlevel", slot.invert ? 1 - *zero : *zero);
        warnings.push_back({"midlevel-set",
            file + ": its heights have a sign: midlevel " + shortText(double(state.parameters.midlevel)) + " keeps zero on the mesh"});
    }
}

std::optional<Warning> unfinishedExport(const fs::path& folder)
{
    if (!numbersIn(folder).contains(kUnfinishedExport))
        return std::nullopt;
    return Warning{"export-unfinished",
        folder.string()
            + ": an export into this folder has not come to its end: maps may be missing or of different exports. Export again."};
}

bool takeReliefJson(const fs::path& folder, State& state, Warnings& warnings)
{
    if (std::optional<Warning> unfinished = unfinishedExport(folder)) {
        warnings.push_back(std::move(*unfinished));
        return false;
    }
    const json numbers = numbersIn(folder);
    if (!numbers.is_object() || std::isnan(numberOf(numbers, "depthInTiles")) || textOf(numbers, "technique").empty())
        return false;
    for (const auto& [key, parameter] : kReliefNumbers)
        takeNumber(state, std::ranges::find(kParameters, Member(parameter), &ParameterRow::member)->key, numberOf(numbers, key));
    if (const auto offset = numbers.find("offset");
        offset != numbers.end() && offset->is_array() && offset->size() == 2 && (*offset)[0].is_number() && (*offset)[1].is_number()) {
        takeNumber(state, "offsetU", (*offset)[0].get<double>());
        takeNumber(state, "offsetV", (*offset)[1].get<double>());
    }
    if (const auto wrap = choiceOf<Wrap>(textOf(numbers, "wrap")))
        state.parameters.wrap = *wrap;
    takeTechnique(state, textOf(numbers, "technique"));
    bool turned = false;
    if (const auto maps = numbers.find("maps"); maps != numbers.end() && maps->is_array())
        for (const json& map : *maps)
            turned |= takeConvention(state, map);
    if (turned) // what the pixels had suggested
        std::erase_if(warnings,
            [](const Warning& w) { return w.code == "normal-contradicts-height" || w.code == "depth-map" || w.code == "normal-directx"; });
    warnings.push_back({"relief-json", "Depth, technique and placement are those of relief.json in the folder."});
    return true;
}

} // namespace relievo
