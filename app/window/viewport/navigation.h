// What the hand does in the picture: a table of gestures, and the camera moves as functions of values.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/camera_view.h"
#include "core/state/state.h"
#include <Qt>
#include <array>
#include <optional>
#include <string_view>

namespace relievo {

enum class Gesture { Orbit, Pan, Zoom, Fly, Light };
struct GestureRow {
    Gesture gesture;
    Qt::MouseButton button;
    int modifiers; // all of these, and no other of Shift, Ctrl and Alt
    bool lightKey; // while L is held
    std::string_view text; // "Shift + left drag"
    std::string_view does;
};
// The first row that fits is taken.
inline constexpr auto kGestures = std::to_array<GestureRow>({
    {Gesture::Light, Qt::LeftButton, Qt::NoModifier, true, "L + left drag", "turn the light"},
    {Gesture::Light, Qt::RightButton, Qt::ShiftModifier, false, "Shift + right drag", "turn the light"},
    {Gesture::Orbit, Qt::LeftButton, Qt::NoModifier, false, "Left drag", "orbit"},
    {Gesture::Orbit, Qt::LeftButton, Qt::AltModifier, false, "Alt + left drag", "orbit"},
    {Gesture::Pan, Qt::MiddleButton, Qt::NoModifier, false, "Middle drag", "move sideways"},
    {Gesture::Pan, Qt::MiddleButton, Qt::AltModifier, false, "Alt + middle drag", "move sideways"},
    {Gesture::Pan, Qt::LeftButton, Qt::ShiftModifier, false, "Shift + left drag", "move sideways"},
    {Gesture::Zoom, Qt::LeftButton, Qt::ControlModifier, false, "Ctrl + left drag", "move closer or away"},
    {Gesture::Zoom, Qt::RightButton, Qt::AltModifier, false, "Alt + right drag", "move closer or away"},
    {Gesture::Fly, Qt::RightButton, Qt::NoModifier, false, "Right drag", "look around; W A S D E Q fly meanwhile"},
});
std::optional<Gesture> gestureFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, bool lightKey);

// What a key does to the camera while nothing is dragged: about the mesh by so many pixels of a drag, closer by steps of the wheel.
struct CameraKeyRow {
    Qt::Key key;
    double right, down, closer;
    std::string_view does;
};
inline constexpr auto kCameraKeys = std::to_array<CameraKeyRow>({
    {Qt::Key_Left, -25., 0., 0., "orbit to the left"},
    {Qt::Key_Right, 25., 0., 0., "orbit to the right"},
    {Qt::Key_Up, 0., 25., 0., "orbit upwards"},
    {Qt::Key_Down, 0., -25., 0., "orbit downwards"},
    {Qt::Key_PageUp, 0., 0., 1., "move closer"},
    {Qt::Key_PageDown, 0., 0., -1., "move away"},
});

// Fields of view to choose from, degrees upwards.
inline constexpr std::array<float, 7> kFieldsOfView = {10.f, 20.f, 28.f, 35.f, 50.f, 65.f, 90.f};
double focalLength(float fieldOfView); // mm of a 35 mm camera, whose picture is 24 mm high
Camera withFieldOfView(const Camera& camera, float fieldOfView); // what it looks at stays as large as it is

// dx, dy: pixels to the right and down; view: what the camera sees now; height: of the picture in pixels.
Camera orbited(const Camera& camera, double dx, double dy);
Camera panned(const Camera& camera, const CameraView& view, double dx, double dy, double height); // the target follows the hand
Camera zoomed(const Camera& camera, const CameraView& view, double steps); // a step (wheel notch) is an eighth closer
Camera lookedAround(const Camera& camera, const CameraView& view, double dx, double dy); // about the eye
Camera flown(const Camera& camera, const CameraView& view, double right, double up, double forward); // m
Camera framed(const Camera& camera); // from the same side, the whole mesh

} // namespace relievo
