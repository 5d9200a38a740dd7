// The State: everything that decides the picture, as one plain value (ARCHITECTURE.md, "State").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/map_slots.h"
#include "core/state/parameters.h"
#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relievo {

struct Camera {
    float yaw = 30.f; // degrees about y; 0 looks from +z
    float pitch = 35.f; // degrees above the horizon; 90 looks straight down
    float fov = 35.f; // degrees, vertical
    std::optional<float> distance; // m from eye to target; nothing: frames the mesh
    std::optional<glm::vec3> target; // m; nothing: the centre of the mesh
    // Without distance: the share of the picture's width or height that the mesh fills, in (0, 1]; 0: room enough for its whole box.
    float fill = 0.f;
    bool operator==(const Camera&) const = default;
};

// One picture of the window: a technique and a view, and what differs from the shared State. An unlinked pane holds a camera of its own,
// and its own light as overrides; linked ones follow the State's.
struct Pane {
    std::string technique = "relief"; // key of kTechniques
    std::map<std::string, Value> overrides = {}; // by parameter key
    std::string view = "shaded"; // key of kViews
    std::optional<Camera> camera = {};
    bool operator==(const Pane&) const = default;
};
inline constexpr std::size_t kMaxPanes = 6;

struct State {
    std::string name = "Untitled";
    Parameters parameters;
    MapSlots slots;
    std::string mesh = "plane"; // a shape's key or an absolute path
    std::string part; // material of the mesh file whose parts show this material; "" for all, the others are plain
    std::string environment = "studio"; // a key of kEnvironments or an absolute path
    Camera camera; // of the linked panes
    std::vector<Pane> panes = {Pane{}}; // 1 to kMaxPanes
    bool operator==(const State&) const = default;
};

// Whether a State's mesh is a relief object (resources/help/objects.md), by its name.
inline constexpr std::string_view kObjectSuffix = ".object.json"; // of NAME.object.json
bool isObjectName(std::string_view mesh);
// Panes whose technique cannot draw the State's mesh get one that can: relief objects have techniques of their own.
void fitTechniques(State& state);

// The parameters that pane `index` is drawn with: the shared ones under the pane's overrides.
Parameters effectiveParameters(const State& state, std::size_t pane);
// The camera that it is seen by: its own, or the shared one.
const Camera& cameraOf(const State& state, std::size_t pane);
void setCameraOf(State& state, std::size_t pane, const Camera& camera);
// The State with one plain pane and no floor, for measuring: what the first pane overrides and its own camera have become the State's.
State ofFirstPane(const State& state);
// Shows all panes by this view, a key of kViews.
void setView(State& state, std::string_view view);

// metresPerUV as set, or as measured of the mesh when the parameter is 0; never 0.
float metresPerUV(const Parameters& parameters, float measuredOfMesh);
// D: black-to-white distance in metres = depth x metresPerUV / tiling.
float physicalDepth(const Parameters& parameters, float measuredOfMesh);

// Applies "KEY=VALUE" of --set. Unknown key, wrong kind or out of range: an error that names the key and what is allowed.
Expected<void> setParameter(State& state, std::string_view assignment);
// Applies "yaw=30,pitch=35,distance=2,target=0:1:0,fov=35" of --camera (any subset); also reads what toText(camera) wrote.
Expected<void> setCamera(Camera& camera, std::string_view text);
std::string toText(const Camera& camera);

} // namespace relievo
