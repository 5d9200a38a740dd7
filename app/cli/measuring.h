// What report, tune and compare share: subjects to measure on, and pictures of settings against the most exact one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/cli/command.h"
#include "core/analysis/image_metrics.h"
#include "core/analysis/sweep.h"
#include "render/windowless.h"

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

// Shaded pictures compared with that of the most exact setting, at one size. Needs a current context.
class PictureJudge {
public:
    // resources: completed with acceleration maps; they must outlive the judge.
    static Expected<PictureJudge> create(Renderer& renderer, const State& state, Resources& resources, int width, int height);
    struct Verdict {
        Image picture;
        double psnr, flip;
    };
    Expected<Verdict> judge(const SearchSetting& setting);

private:
    PictureJudge(Renderer& renderer, const State& state, Resources& resources, Image exact);
    Renderer* m_renderer;
    State m_state;
    Resources* m_resources;
    Image m_exact;
    Flip m_flip;
};

} // namespace relievo::cli
