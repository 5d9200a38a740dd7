// Derived values of a State, and its edits from text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/state.h"
#include "core/state/shapes.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <charconv>
#include <cmath>

namespace relievo {

bool isObjectName(std::string_view mesh)
{
    return mesh.ends_with(kObjectSuffix) || !shapeOfObject(mesh).empty();
}

void fitTechniques(State& state)
{
    const bool isObject = isObjectName(state.mesh);
    for (Pane& pane : state.panes)
        if (const TechniqueRow* technique = findTechnique(pane.technique); technique && technique->isOfObjects != isObject)
            pane.technique = isObject ? std::string(kObjectTechniques.front().key) : Pane{}.technique;
}

Parameters effectiveParameters(const State& state, std::size_t pane)
{
    Parameters parameters = state.parameters;
    if (pane < state.panes.size())
        for (const auto& [key, value] : state.panes[pane].overrides)
            if (const ParameterRow* row = findParameter(key); row && isOfKind(*row, value))
                set(parameters, *row, value);
    return parameters;
}

const Camera& cameraOf(const State& state, std::size_t pane)
{
    return pane < state.panes.size() && state.panes[pane].camera ? *state.panes[pane].camera : state.camera;
}

void setCameraOf(State& state, std::size_t pane, const Camera& camera)
{
    if (pane < state.panes.size() && state.panes[pane].camera)
        state.panes[pane].camera = camera;
    else
        state.camera = camera;
}

State ofFirstPane(const State& state)
{
    State plain = state;
    plain.parameters = effectiveParameters(state, 0);
    plain.camera = cameraOf(state, 0);
    plain.panes = {Pane{state.panes.front().technique}};
    plain.parameters.ground = false;
    return plain;
}

void setView(State& state, std::string_view view)
{
    for (Pane& pane : state.panes)
        pane.view = view;
}

float metresPerUV(const Parameters& parameters, float measuredOfMesh)
{
    const float metres = parameters.metresPerUV > 0.f ? parameters.metresPerUV : measuredOfMesh;
    return metres > 0.f && std::isfinite(metres) ? metres : 1.f;
}

float physicalDepth(const Parameters& parameters, float measuredOfMesh)
{
    return parameters.depth * metresPerUV(parameters, measuredOfMesh) / parameters.tiling;
}

namespace {
std::string rangeText(const ParameterRow& row)
{
    if (kindOf(row) == ValueKind::Choice)
        return "One of " + optionList(row, '|');
    if (kindOf(row) == ValueKind::Switch)
        return "true or false";
    const auto number = [](float v) {
        char buffer[32];
        return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, v).ptr);
    };
    const std::string range = number(row.min) + " to " + number(row.max) + (row.unit.empty() ? "" : " " + std::string(row.unit));
    return kindOf(row) == ValueKind::Color ? "R,G,B, each " + range : range;
}
} // namespace

Expected<void> setParameter(State& state, std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    const std::string key(assignment.substr(0, equals));
    if (equals == assignment.npos)
        return failure("--set " + key, "there is no value", "Write --set KEY=VALUE");
    const ParameterRow* row = findParameter(key);
    if (!row)
        return failure(ErrorCode::NotFound, "--set " + key, "there is no such parameter", "relievo describe parameters lists them");
    const std::string text(assignment.substr(equals + 1));
    const auto value = parseValue(*row, text);
    if (!value || !inRange(*row, *value))
        return failure(
            "--set " + key, '"' + text + (value ? "\" is out of range" : "\" is not a value of this parameter"), rangeText(*row));
    set(state.parameters, *row, *value);
    for (Pane& pane : state.panes) // what is asked for now wins over a pane's own value
        pane.overrides.erase(key);
    return {};
}

namespace {
std::optional<float> finiteNumber(std::string_view text)
{
    float value = 0.f;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

std::optional<glm::vec3> point(std::string_view text)
{
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    if (first == text.npos || second == text.npos)
        return {};
    const auto x = finiteNumber(text.substr(0, first)), y = finiteNumber(text.substr(first + 1, second - first - 1)),
               z = finiteNumber(text.substr(second + 1));
    if (!x || !y || !z)
        return {};
    return glm::vec3(*x, *y, *z);
}

bool setCameraPart(Camera& camera, std::string_view key, std::string_view text)
{
    if (key == "target") {
        const auto p = point(text);
        if (p)
            camera.target = *p;
        return p.has_value();
    }
    const auto number = finiteNumber(text);
    if (!number)
        return false;
    if (key == "yaw")
        camera.yaw = *number;
    else if (key == "pitch" && std::abs(*number) <= 90.f)
        camera.pitch = *number;
    else if (key == "fov" && *number >= 1.f && *number <= 170.f)
        camera.fov = *number;
    else if (key == "distance" && *number > 0.f)
        camera.distance = *number, camera.fill = 0.f; // unless that is said too
    else if (key == "fill" && *number >= 0.f && *number <= 1.f)
        camera.fill = *number;
    else
        return false;
    return true;
}
} // namespace

Expected<void> setCamera(Camera& camera, std::string_view text)
{
    Camera changed = camera;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(','));
        const std::size_t equals = part.find('=');
        if (equals == part.npos || !setCameraPart(changed, part.substr(0, equals), part.substr(equals + 1)))
            return failure("--camera " + std::string(part), "this is not a camera setting",
                "Write yaw=DEG,pitch=-90..90 DEG,distance=M above 0,target=X:Y:Z in M,fov=1..170 DEG,fill=0..1, any of them");
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
    camera = changed;
    return {};
}

std::string toText(const Camera& camera)
{
    const auto number = [](float v) {
        char buffer[32];
        return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, v).ptr);
    };
    std::string text = "yaw=" + number(camera.yaw) + ",pitch=" + number(camera.pitch) + ",fov=" + number(camera.fov);
    if (camera.distance)
        text += ",distance=" + number(*camera.distance);
    if (camera.fill > 0.f)
        text += ",fill=" + number(camera.fill);
    if (camera.target)
        text += ",target=" + number(camera.target->x) + ':' + number(camera.target->y) + ':' + number(camera.target->z);
    return text;
}

} // namespace relievo
