// How far pictures from afar are off with each setting of the filters.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/report.h"
#include "render/windowless.h"

namespace relievo {

// The State's first pane on a plane that fills the picture, at two angles and three distances, with its light. Settings that filter normals
// are left out where the material has no normal map. Maps of `resources` are made where they are missing. Needs a current context and a
// height map.
Expected<FarSection> measureFarViews(Renderer& renderer, const State& state, const Resources& resources, const Progress& progress = {});

} // namespace relievo
