// Putting a request together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/draw_request.h"
#include <utility>

namespace relievo {

DrawRequest::DrawRequest(const State& state, std::size_t pane, const Resources& resources, const Target& target, std::string_view view)
    : m_state(state)
    , m_pane(pane)
    , m_resources(resources)
    , m_target(target)
    , m_view(!view.empty() || pane >= state.panes.size() ? view : state.panes[pane].view)
    , m_camera(cameraOnto(*resources.mesh, cameraOf(state, pane), aspectOf(target)))
{
}

bool DrawRequest::compareWith(std::shared_ptr<const ExactDistances> exact)
{
    m_exact = exact && exact->question == exactQuestion(m_state, m_pane, m_resources, m_target.width, m_target.height) ? std::move(exact)
                                                                                                                       : nullptr;
    return m_exact != nullptr;
}

} // namespace relievo
