// What the window starts with.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"

namespace relievo {

// The built-in material of a new document.
inline constexpr const char* kStartingSource = "sample:cobblestones";

// What a new document, and maps that the window is started with, are shown on: a sphere with true silhouettes that fills the pane, its
// poles out of sight, on a floor before a soft backdrop. A value of the window's alone: projects and the command line go by the defaults of
// State.
inline State startingScene()
{
    State state;
    state.mesh = "sphere";
    state.parameters.tiling = 2.f;
    state.parameters.silhouettes = Silhouettes::Prisms;
    state.parameters.background = Backdrop::Gradient;
    state.parameters.ground = true;
    state.camera.pitch = 8.f;
    state.camera.fill = 0.87f;
    return state;
}

} // namespace relievo
