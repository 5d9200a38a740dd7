// What stands over the panes and where: captions, legends of heat maps, the hint.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/text.h"
#include "core/state/views.h"
#include <algorithm>

namespace relievo {
namespace {
constexpr int kMargin = 12; // px from the picture's edge to what lies over it
}

void Viewport::setActivePane(int pane)
{
    pane = std::clamp(pane, 0, paneCount() - 1);
    if (pane == m_activePane)
        return;
    m_activePane = pane;
    updateOverlays();
    Q_EMIT activePaneChanged(pane);
}

void Viewport::placeOverlays()
{
    const double scale = devicePixelRatioF();
    const bool eachItsOwn = !m_legends[1]->isHidden();
    for (int pane = 0; pane < 2; ++pane) {
        const PaneArea place = pane < paneCount() ? area(pane) : PaneArea{};
        const int left = int(place.x / scale) + kMargin;
        m_captions[std::size_t(pane)]->move(left, kMargin);
        m_captions[std::size_t(pane)]->fit(int(place.width / scale) - 2 * kMargin);
        HeatLegend& legend = *m_legends[std::size_t(pane)];
        const int room = int((eachItsOwn ? place.width : area(0).width * paneCount()) / scale) - 2 * kMargin;
        legend.resize(std::clamp(room, 0, legend.sizeHint().width()), legend.sizeHint().height());
        // One range of two panes stands between them, over both.
        const bool between = paneCount() > 1 && !eachItsOwn;
        legend.move(between ? (width() - legend.width()) / 2 : left, height() - kMargin - legend.height());
    }
    const int floor = m_legends[0]->isHidden() ? height() : m_legends[0]->y();
    m_hint->move((width() - m_hint->width()) / 2, floor - kMargin - m_hint->height());
}

void Viewport::updateOverlays()
{
    const State& state = m_document.state();
    const ViewRow* view = findView(state.view);
    const bool isHeat = view && view->isHeat;
    const auto range = [&](int pane) { return double(heatRange(effectiveParameters(state, std::size_t(pane)), state.view)); };
    for (int pane = 0; pane < 2; ++pane) {
        PaneCaption* caption = m_captions[std::size_t(pane)];
        HeatLegend* legend = m_legends[std::size_t(pane)];
        caption->setVisible(pane < paneCount());
        legend->setVisible(isHeat && pane < paneCount() && (pane == 0 || range(pane) != range(0)));
        if (pane >= paneCount())
            continue;
        const auto& measured = m_measured[std::size_t(pane)];
        const QString cost = measured ? tr("%1 fetches/px").arg(measured->meanFetches, 0, 'f', 1) : QString();
        caption->show(paneCount() == 1 ? "" : pane == 0 ? "A" : "B", techniqueText(state, std::size_t(pane)), cost, pane == m_activePane);
        if (isHeat)
            legend->show(qt(view->label), qt(view->unit), range(pane));
    }
    placeOverlays();
}

} // namespace relievo
