// What report, tune and compare share: subjects to measure on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/cli/command.h"
#include "core/analysis/sweep.h"

namespace relievo::cli {

// A material opened for measuring: its State and the height field under the State's wrap.
struct Subject {
    State state;
    Resources resources; // only the material, unless asked for all
    SweepField field;
    Warnings warnings;
};
// whole: with mesh and environment, for pictures. A material without a height map is an error.
Result<Subject> openSubject(const StateOptions& options, bool whole, const Progress& progress);

// The rows that `--techniques` names; all but engines' when empty. A wrong key is wrong usage.
Result<std::vector<const TechniqueRow*>> techniquesOf(const std::vector<std::string>& keys);

} // namespace relievo::cli
