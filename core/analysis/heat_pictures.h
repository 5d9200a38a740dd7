// Pictures of what a search costs and where it errs: a tilted plane seen from afar, searched on the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/settings.h"
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/image/image.h"

namespace relievo {

struct HeatView {
    double angle = 75.; // between view and normal, degrees
    double depth = 0.08; // share of the tile
    int width = 320, height = 200; // pixels; one tile spans the width
    double fetchRange = 40., errorRange = 0.05; // at the bright end
};

struct HeatPictures {
    Image fetches, error; // RGB U8, display values of the heat map (heatColor); error: |t - exact|
    double meanFetches, meanError;
};

// Errors: those of searchMaps, cancelled.
Expected<HeatPictures> heatPictures(
    const SearchSetting& setting, const HeightField& heights, const HeatView& view, const Progress& progress = {});

} // namespace relievo
