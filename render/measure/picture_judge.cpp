// Judging pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/picture_judge.h"
#include "core/state/views.h"

namespace relievo {

PictureJudge::PictureJudge(Renderer& renderer, const State& state, Resources& resources, Image exact)
    : m_renderer(&renderer)
    , m_state(state)
    , m_resources(&resources)
    , m_exact(std::move(exact))
    , m_flip(m_exact)
{
}

Expected<PictureJudge> PictureJudge::create(Renderer& renderer, const State& state, Resources& resources, int width, int height)
{
    const State exact = withSetting(state, mostExactSetting(effectiveParameters(state, 0)));
    auto picture = drawPicture(renderer, exact, 0, resources, knownView("shaded").key, width, height, 1, false);
    if (!picture)
        return tl::unexpected(picture.error());
    return PictureJudge(renderer, state, resources, std::move(*picture));
}

Expected<PictureJudge::Verdict> PictureJudge::judge(const SearchSetting& setting)
{
    auto picture = drawPicture(
        *m_renderer, withSetting(m_state, setting), 0, *m_resources, knownView("shaded").key, m_exact.width, m_exact.height, 1, false);
    if (!picture)
        return tl::unexpected(picture.error());
    const double noise = psnr(m_exact, *picture), flip = m_flip.mean(*picture);
    return Verdict{std::move(*picture), noise, flip};
}

} // namespace relievo
