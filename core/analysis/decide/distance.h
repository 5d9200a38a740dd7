// What a setting costs and how wrong it looks from afar: where the relief moves nothing by a pixel any more, bump mapping shows the same.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/sweep.h"
#include <array>
#include <vector>

namespace relievo {

inline constexpr std::array<double, 4> kDistanceAngles = {30., 60., 75., 85.}; // between view and normal, degrees

// At one angle, at full resolution.
struct AngleFigures {
    double angle; // degrees
    HitErrors errors; // of the setting
    double parallax; // RMS of the depth by which the exact hits lie off the mesh, share of the relief's depth
};
// midlevel: the height that lies on the mesh. Errors: those of searchMaps, cancelled.
Expected<std::vector<AngleFigures>> figuresByAngle(
    const SearchSetting& setting, const HeightField& heights, double midlevel, const Progress& progress = {});

// What a picture makes of a metre: its vertical field of view in degrees, and its height in pixels.
struct Lens {
    double fov, height;
    double pixels(double metres, double distance) const; // across the view, at that distance in metres
};
// Pixels by which an error of `share` of a relief of `depth` metres shifts what is seen: d sin(angle) across the view.
double shiftInPixels(double share, double depth, double angle, const Lens& lens, double distance);

// Metres from which on the shifts at all angles are at most `pixels`: of the relief itself, or of the setting's errors. 0 where there are
// none.
double distanceOfParallax(std::span<const AngleFigures> figures, double depth, const Lens& lens, double pixels = 1.);
double distanceOfErrors(std::span<const AngleFigures> figures, double depth, const Lens& lens, double pixels = 1.);

} // namespace relievo
