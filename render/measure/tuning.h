// Finding the cheapest technique and setting within a budget, for the command line and the window alike, with the proof.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/decide/view_rays.h"
#include "core/analysis/tune.h"
#include "core/scene/resources.h"
#include <optional>

namespace relievo {

enum class TuneMetric { Depth, Pixels, Flip };
struct TuneMetricRow {
    TuneMetric metric;
    std::string_view key, label, unit;
};
inline constexpr std::array<TuneMetricRow, 3> kTuneMetrics = {{
    {TuneMetric::Depth, "depth", "RMSE of the depth", "share of the depth"},
    {TuneMetric::Pixels, "pixels", "RMSE of the texture's shift, pixels", "pixels"},
    {TuneMetric::Flip, "flip", "mean FLIP", "0 to 1"},
}};

// Where from the material is looked at.
enum class TuneViews {
    Angles, // on a plane: kAngleBands, and pictures of a tile at kPictureAngles
    Seen, // the pane's view alone
    Around, // kTurns views around the mesh, from the pane's height and distance
    Clip, // the pane's view of kTurns moments of the animation
};
inline constexpr int kTurns = 8;

struct TuneQuestion {
    TuneMetric metric = TuneMetric::Depth;
    TuneViews views = TuneViews::Angles;
    TuneBudget budget = {};
    bool leastError = false; // instead of the least cost: of what is within the budget but for its maxError
    std::vector<const TechniqueRow*> techniques = {}; // none: all but engines
    int rays = 2000; // in each band of angles
    std::uint32_t seed = 1;
    ViewGrid grid = {}; // of the other views
};

struct Tuned {
    std::vector<SearchSetting> settings;
    std::vector<std::string> views; // "60-80", "45\u00b0"; what the rows call bands
    std::vector<SweepRow> rows;
    std::vector<Candidate> candidates; // cheapest first
    std::optional<std::size_t> chosen; // of the candidates
};

// Of the State's first pane. Depth, and Pixels of all views but Angles, are told by rays, the rest by pictures of 400 x 300 pixels, for
// which an OpenGL context is made. Resources: with mesh and environment unless the metric is Depth and the views are Angles. Errors: no
// heights, no relief in view, no context, those of searchMaps, cancelled.
Expected<Tuned> tune(const State& state, const Resources& resources, const TuneQuestion& question, const Progress& progress = {});

} // namespace relievo
