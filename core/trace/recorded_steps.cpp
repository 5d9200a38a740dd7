// Turning what a search tells into steps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/recorded_steps.h"
#include <utility>

namespace relievo {

void StepRecorder::step(StepKind kind, float to, int reads)
{
    const double from = m_steps.empty() ? 0. : m_steps.back().to, end = m_share * double(to);
    const int fetches = reads - std::exchange(m_reads, reads);
    if (from == end && fetches == 0)
        return;
    m_steps.push_back({kind, from, end, at(kind == StepKind::Offset ? 0. : end), 0., fetches});
}

void StepRecorder::halving(float from, float to, float middle, int reads)
{
    m_steps.push_back({StepKind::Halving, m_share * double(from), m_share * double(to), at(m_share * double(middle)), 0.,
        reads - std::exchange(m_reads, reads)});
}

void StepRecorder::read(StepKind kind, int reads)
{
    if (m_steps.empty())
        m_steps.push_back({kind, 0., 0., at(0.), 0., 0});
    m_steps.back().fetches += reads - std::exchange(m_reads, reads);
}

std::vector<SearchStep> StepRecorder::finish(const SearchHit& hit, const HeightField* field) &&
{
    if (!m_steps.empty()) {
        const SearchStep last = m_steps.back();
        if (last.kind == StepKind::Halving && last.from <= hit.t && hit.t <= last.to) // the middle of the last bracket was taken
            m_steps.back().to = hit.t;
        else if (last.kind != StepKind::Halving && last.to > hit.t) // walks end a little beyond the floor
            m_steps.back().to = hit.t, m_steps.back().uv = at(hit.t);
        else if (last.to != hit.t)
            m_steps.push_back({last.kind, last.to, hit.t, at(hit.t), 0., 0});
        m_steps.back().fetches += hit.fetches - m_reads; // reads whose answer was not used
    }
    if (field)
        for (SearchStep& step : m_steps)
            step.height = double(field->at(glm::vec2(step.uv)));
    return std::move(m_steps);
}

} // namespace relievo
