// Pictures of settings against that of the most exact one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/image_metrics.h"
#include "core/analysis/settings.h"
#include "render/windowless.h"

namespace relievo {

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

} // namespace relievo
