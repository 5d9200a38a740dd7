// What an engine will show of a material's relief, in numbers: how much of its depth, and how far from the exact answer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/state/techniques.h"
#include <string>

namespace relievo {

inline constexpr double kEngineAngle = 70.; // degrees between view and normal, at which a sentence tells of it

struct EngineDrawing {
    // Of the depth: the factor from exact depths to those drawn that leaves the least sum of absolute differences, so that rays which pass
    // through a thin wall count in the error, not here. Both are counted from the height that the engine puts on its mesh. 1 where there is
    // no depth to draw.
    double share = 1.;
    double meanError = 0.; // mean of |depth drawn - exact depth|, share of the depth, with that height where the exact answer has it
    // By how much the whole lies higher than the midlevel has it, since the engine puts another height on the mesh; share of the depth.
    double raised = 0.;
};

// technique: a row of an engine; any other with a text is measured alike. parameters: depth, midlevel, and what the search depends on. 4096
// rays, the same for equal arguments, on the finest level with the field's own wrap. Errors: those of searchMaps, cancelled.
Expected<EngineDrawing> drawnBy(const TechniqueRow& technique, const Parameters& parameters, const HeightField& field,
    double angle = kEngineAngle, const Progress& progress = {});

// "Godot 4 will draw 66 % less depth at 70 degrees; mean error 0.11 of the depth", and how much too high, where it is.
std::string sentence(const TechniqueRow& technique, const EngineDrawing& drawing, double angle = kEngineAngle);

} // namespace relievo
