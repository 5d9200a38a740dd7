// Turning a State for a sequence of pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/render/turntable.h"
#include <algorithm>
#include <cmath>
#include <string>

namespace relievo::cli {
namespace {
float wrapped(float degrees) // into [-180, 180]
{
    return degrees - 360.f * std::round(degrees / 360.f);
}
} // namespace

std::filesystem::path numbered(const std::filesystem::path& pattern, int number)
{
    std::string name = pattern.filename().string();
    const std::size_t last = name.rfind('#');
    if (last == std::string::npos)
        return {};
    const std::size_t before = name.find_last_not_of('#', last), first = before == std::string::npos ? 0 : before + 1;
    std::string digits = std::to_string(number);
    digits.insert(0, std::max(last + 1 - first, digits.size()) - digits.size(), '0');
    return pattern.parent_path() / name.replace(first, last + 1 - first, digits);
}

State turned(const State& state, Turn turn, float share)
{
    State one = state;
    if (turn == Turn::Camera) {
        Camera camera = cameraOf(state, 0);
        camera.yaw = wrapped(camera.yaw + 360.f * share);
        setCameraOf(one, 0, camera);
    } else {
        one.panes.front().overrides["lightTurn"] = std::fmod(effectiveParameters(state, 0).lightTurn + 360.f * share, 360.f);
    }
    return one;
}

State withRoomToTurn(const State& state, const Mesh& mesh, int frames, float aspect)
{
    Camera camera = cameraOf(state, 0);
    if (camera.distance)
        return state;
    float furthest = 0.f;
    for (int i = 0; i < frames; ++i) {
        Camera one = camera;
        one.yaw = wrapped(camera.yaw + 360.f * float(i) / float(frames));
        furthest = std::max(furthest, cameraOnto(mesh, one, aspect).distance);
    }
    if (!camera.target)
        camera.target = cameraOnto(mesh, camera, aspect).target;
    camera.distance = furthest;
    State roomy = state;
    setCameraOf(roomy, 0, camera);
    return roomy;
}

} // namespace relievo::cli
