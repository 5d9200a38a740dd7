// How far a picture's search is from the exact first hit at each pixel, and views made for measuring.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/windowless.h"
#include <array>

namespace relievo {

// The State as a plane that fills the picture, seen from afar at `angle` degrees from its normal (at most 85): full resolution, no
// shadows, no push-out, repeated tiles, whatever the first pane overrides. `kTilesAcross` tiles span the picture's width where it is 4 : 3.
State fillingView(const State& state, double angle);
Resources fillingResources(Resources resources); // what that is drawn with: the same with a plane as mesh
inline constexpr double kTilesAcross = 0.93;
inline constexpr std::array<double, 4> kPictureAngles = {30., 60., 75., 85.};

// Over the pixels that the mesh covers. Errors are those of the search along the ray at each pixel: from the exact first hit of the same
// ray on the tangent plane (bent, with silhouettes), not from the displaced mesh.
struct PictureErrors {
    double meanFetches = 0., maxFetches = 0.; // of the search
    double rmse = 0., largest = 0.; // of the depth found, share of the relief's depth
    double missed = 0.; // share of the pixels whose search went through the first surface: too deep by more than kMissedDepth
    double covered = 0.; // share of the picture
};
inline constexpr double kMissedDepth = 0.02; // share of the relief's depth

// The State's first pane at full resolution (heightMips off). Needs a current context and a height map.
Expected<PictureErrors> pictureErrors(Renderer& renderer, const State& state, Resources& resources, int width, int height);

} // namespace relievo
