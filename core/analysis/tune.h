// Choosing the cheapest technique and settings whose error is within a budget.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/sweep.h"
#include <functional>
#include <limits>

namespace relievo {

struct TuneBudget {
    double maxError = 0.; // in the metric's unit
    double maxMissed = 1.; // share of the rays that may go through the first surface, in the worst band
    double maxFetches = std::numeric_limits<double>::infinity(); // mean of the bands
};

// One setting, summed up over the bands. "Worst" bands are those of the largest figure.
struct Candidate {
    std::size_t setting; // index into the plan
    double meanFetches; // mean of the bands: each counts the same
    int maxFetches;
    double error; // of the worst band, or what `errorOf` said; NaN while unknown
    double missed; // share, worst band
    bool within = false;
};

// Candidates of a sweep over one field, cheapest first: by mean fetches, then by the most. error: that figure in the worst band.
std::vector<Candidate> candidatesOf(std::span<const SweepRow> rows, std::size_t settings, double HitErrors::*error = &HitErrors::rmse);

// Judges every candidate and returns the first that is within the budget, or nothing. With `errorOf` (pictures: slow) errors are asked for
// in order until one candidate is found, and those after it keep a NaN.
using ErrorOf = std::function<Expected<double>(std::size_t setting)>;
Expected<const Candidate*> choose(std::vector<Candidate>& candidates, const TuneBudget& budget, const ErrorOf& errorOf = {});
// Returns the one with the least error of those that miss and fetch no more than the budget allows, whatever its maxError; the cheapest of
// equals. With `errorOf` all of them are asked for.
Expected<const Candidate*> chooseLeast(std::vector<Candidate>& candidates, const TuneBudget& budget, const ErrorOf& errorOf = {});

} // namespace relievo
