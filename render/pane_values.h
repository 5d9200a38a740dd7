// The values that a pane and the parts of its mesh are drawn with.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include "core/state/views.h"

namespace relievo {

// What the pane needs to be drawn; views against the exact answer measure the search itself, at full resolution, and engines are drawn so.
Parameters drawnParameters(const State& state, std::size_t pane, const TechniqueRow& technique, const ViewRow& view);

// What the light draws of a picture: its depth.
ProgramFeatures intoShadowMap(ProgramFeatures features, const TechniqueRow& technique);

// Of parts that the material is not on: grey, smooth, where they are.
ProgramFeatures withoutRelief(ProgramFeatures features);
SceneUniforms withoutRelief(SceneUniforms uniforms);

} // namespace relievo
