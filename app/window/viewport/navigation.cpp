// Camera moves.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/navigation.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {
constexpr double kDegreesPerPixel = 0.4;
constexpr float kFramedFill = 0.87f; // of the pane
constexpr float kClosest = 0.001f, kFarthest = 10000.f; // m

float wrapped(double degrees)
{
    return float(std::remainder(degrees, 360.));
}

float pitched(double degrees)
{
    return float(std::clamp(degrees, -90., 90.));
}
} // namespace

std::optional<Gesture> gestureFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, bool lightKey)
{
    const int held = int(modifiers & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier));
    for (const GestureRow& row : kGestures)
        if (row.button == button && row.modifiers == held && (!row.lightKey || lightKey))
            return row.gesture;
    return {};
}

Camera orbited(const Camera& camera, double dx, double dy)
{
    Camera next = camera;
    next.yaw = wrapped(camera.yaw - dx * kDegreesPerPixel);
    next.pitch = pitched(camera.pitch + dy * kDegreesPerPixel);
    return next;
}

namespace {
double halfHeight(float fieldOfView) // at a distance of 1
{
    return std::tan(double(fieldOfView) * std::numbers::pi / 360.);
}
} // namespace

double focalLength(float fieldOfView)
{
    return 12. / halfHeight(fieldOfView);
}

Camera withFieldOfView(const Camera& camera, float fieldOfView)
{
    Camera next = camera;
    next.fov = fieldOfView;
    if (camera.distance) // else it frames the mesh anyway
        next.distance = float(double(*camera.distance) * halfHeight(camera.fov) / halfHeight(fieldOfView));
    return next;
}

Camera panned(const Camera& camera, const CameraView& view, double dx, double dy, double height)
{
    const double metres = 2. * view.distance * halfHeight(camera.fov) / height; // a pixel at the target
    Camera next = camera;
    next.target = view.target - view.right * float(dx * metres) + view.up * float(dy * metres);
    next.distance = view.distance;
    return next;
}

Camera zoomed(const Camera& camera, const CameraView& view, double steps)
{
    Camera next = camera;
    next.target = view.target;
    next.distance = std::clamp(view.distance * float(std::pow(0.875, steps)), kClosest, kFarthest);
    return next;
}

Camera lookedAround(const Camera& camera, const CameraView& view, double dx, double dy)
{
    Camera next = camera;
    next.yaw = wrapped(camera.yaw - dx * kDegreesPerPixel / 2);
    next.pitch = pitched(camera.pitch + dy * kDegreesPerPixel / 2);
    next.distance = view.distance;
    next.target = view.eye - directionTo(next.yaw, next.pitch) * view.distance;
    return next;
}

Camera flown(const Camera& camera, const CameraView& view, double right, double up, double forward)
{
    const glm::vec3 ahead = (view.target - view.eye) / view.distance;
    Camera next = camera;
    next.distance = view.distance;
    next.target = view.target + view.right * float(right) + view.up * float(up) + ahead * float(forward);
    return next;
}

Camera framed(const Camera& camera)
{
    Camera next = camera;
    next.target.reset();
    next.distance.reset();
    next.fill = kFramedFill;
    return next;
}

} // namespace relievo
