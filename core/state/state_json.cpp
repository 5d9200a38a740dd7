// Project files and presets written: the State walked through its tables to JSON.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/state_json.h"
#include "core/ground/file.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
Json valueJson(const ParameterRow& row, const Value& value)
{
    if (const float* f = std::get_if<float>(&value))
        return Json::parse(toText(row, *f)); // the shortest decimal, not the float widened to double
    if (const int* i = std::get_if<int>(&value))
        return kindOf(row) == ValueKind::Choice ? Json(std::string(option(row, *i))) : Json(*i);
    if (const bool* b = std::get_if<bool>(&value))
        return *b;
    return Json::parse('[' + toText(row, value) + ']');
}

std::string relativeTo(const fs::path& folder, const std::string& file)
{
    if (!fs::path(file).is_absolute())
        return file;
    fs::path relative = fs::path(file).lexically_relative(folder);
    if (!relative.empty() && absolutePath(folder / relative) != file) { // links: ".." leads to the parent of where one points
        std::error_code code;
        const fs::path place = fs::weakly_canonical(fs::path(file).parent_path(), code) / fs::path(file).filename();
        relative = place.lexically_relative(fs::weakly_canonical(folder, code));
    }
    return relative.empty() ? file : relative.generic_string();
}

Json parametersJson(const Parameters& parameters)
{
    Json json = Json::object();
    for (const ParameterRow& row : kParameters)
        json[std::string(row.key)] = valueJson(row, get(parameters, row));
    return json;
}

Json mapsJson(const MapSlots& slots, const fs::path& folder)
{
    Json json = Json::object();
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = slots[std::size_t(row.kind)];
        if (!slot.empty())
            json[std::string(row.key)]
                = {{"file", relativeTo(folder, slot.file)}, {"channel", std::string(wordOf(slot.channel))}, {"invert", slot.invert}};
    }
    return json;
}

Json cameraJson(const Camera& camera)
{
    Json json = {{"yaw", camera.yaw}, {"pitch", camera.pitch}, {"fov", camera.fov}};
    if (camera.distance)
        json["distance"] = *camera.distance;
    if (camera.fill > 0.f)
        json["fill"] = camera.fill;
    if (camera.target)
        json["target"] = {camera.target->x, camera.target->y, camera.target->z};
    return json;
}

Json panesJson(const std::vector<Pane>& panes)
{
    Json json = Json::array();
    for (const Pane& pane : panes) {
        Json overrides = Json::object();
        for (const auto& [key, value] : pane.overrides)
            if (const ParameterRow* row = findParameter(key))
                overrides[key] = valueJson(*row, value);
        Json one = {{"technique", pane.technique}, {"overrides", overrides}};
        if (pane.view != panes.front().view) // the first one's is the project's
            one["view"] = pane.view;
        if (pane.camera)
            one["camera"] = cameraJson(*pane.camera);
        json.push_back(one);
    }
    return json;
}
} // namespace

std::string toJson(const State& state, const fs::path& folder)
{
    const std::string mesh = fs::path(state.mesh).is_absolute() ? relativeTo(folder, state.mesh) : state.mesh;
    const Json json = {{"relievo", kStateVersion}, {"name", state.name}, {"maps", mapsJson(state.slots, folder)},
        {"parameters", parametersJson(state.parameters)}, {"mesh", mesh}, {"part", state.part},
        {"environment", relativeTo(folder, state.environment)}, {"camera", cameraJson(state.camera)}, {"view", state.panes.front().view},
        {"panes", panesJson(state.panes)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string toPresetJson(const State& state)
{
    const std::string technique = state.panes.empty() ? Pane().technique : state.panes.front().technique;
    const Json json = {{"relievo", kStateVersion}, {"parameters", parametersJson(effectiveParameters(state, 0))},
        {"panes", Json::array({Json{{"technique", technique}}})}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

nlohmann::ordered_json searchJson(const TechniqueRow& technique, const Parameters& parameters)
{
    auto json = nlohmann::ordered_json::object();
    for (const ParameterRow& row : kParameters)
        if (searchesBy(technique, row)) {
            const Value value = get(parameters, row);
            if (const bool* on = std::get_if<bool>(&value))
                json[std::string(row.key)] = *on;
            else if (const int* number = std::get_if<int>(&value); number && kindOf(row) == ValueKind::Whole)
                json[std::string(row.key)] = *number;
            else
                json[std::string(row.key)] = toText(row, value);
        }
    return json;
}

Expected<void> writeState(const State& state, const fs::path& file)
{
    return writeAtomically(file, toJson(state, absolutePath(file).parent_path()));
}

} // namespace relievo
