// Ordering by cost, judging by budget.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/tune.h"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace relievo {

std::vector<Candidate> candidatesOf(std::span<const SweepRow> rows, std::size_t settings, double HitErrors::*error)
{
    std::vector<Candidate> candidates;
    for (std::size_t setting = 0; setting < settings; ++setting) {
        Candidate candidate{setting, 0., 0, 0., 0.};
        double bands = 0.;
        for (const SweepRow& row : rows) {
            if (row.setting != setting)
                continue;
            const HitErrors& errors = row.errors;
            bands += 1.;
            candidate.meanFetches += errors.meanFetches;
            candidate.maxFetches = std::max(candidate.maxFetches, errors.maxFetches);
            candidate.error = std::max(candidate.error, errors.invalid ? std::numeric_limits<double>::infinity() : errors.*error);
            candidate.missed = std::max(candidate.missed, errors.share(errors.tooDeep));
        }
        candidate.meanFetches /= std::max(bands, 1.);
        candidates.push_back(candidate);
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return std::tuple(c.meanFetches, c.maxFetches); });
    return candidates;
}

namespace {
bool affordable(const Candidate& candidate, const TuneBudget& budget)
{
    return candidate.missed <= budget.maxMissed && candidate.meanFetches <= budget.maxFetches;
}

// Asked for when it is wanted; NaN when not. What is no number stays broken.
Expected<void> judge(Candidate& candidate, bool wanted, const ErrorOf& errorOf)
{
    if (!errorOf)
        return {};
    const bool broken = std::isinf(candidate.error);
    candidate.error = std::numeric_limits<double>::quiet_NaN();
    if (!wanted || broken)
        return {};
    const auto error = errorOf(candidate.setting);
    if (!error)
        return tl::unexpected(error.error());
    candidate.error = *error;
    return {};
}
} // namespace

Expected<const Candidate*> choose(std::vector<Candidate>& candidates, const TuneBudget& budget, const ErrorOf& errorOf)
{
    const Candidate* chosen = nullptr;
    for (Candidate& candidate : candidates) {
        if (const auto judged = judge(candidate, affordable(candidate, budget) && !chosen, errorOf); !judged)
            return tl::unexpected(judged.error());
        candidate.within = affordable(candidate, budget) && candidate.error <= budget.maxError;
        if (candidate.within && !chosen)
            chosen = &candidate;
    }
    return chosen;
}

Expected<const Candidate*> chooseLeast(std::vector<Candidate>& candidates, const TuneBudget& budget, const ErrorOf& errorOf)
{
    const Candidate* chosen = nullptr;
    for (Candidate& candidate : candidates) {
        if (const auto judged = judge(candidate, affordable(candidate, budget), errorOf); !judged)
            return tl::unexpected(judged.error());
        candidate.within = affordable(candidate, budget) && std::isfinite(candidate.error);
        if (candidate.within && (!chosen || candidate.error < chosen->error))
            chosen = &candidate;
    }
    return chosen;
}

} // namespace relievo
