// Telling and placing what stands over the panes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/pane_overlays.h"
#include "app/window/document/editing.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/panels/pane_menu.h"
#include "app/window/viewport/mesh_reference.h"
#include "app/window/viewport/pane_drops.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/state/views.h"
#include <QMenu>
#include <algorithm>

namespace relievo {

namespace {
constexpr int kMargin = 12; // px from the picture's edge to what lies over it

// A heat map's legend: of which view, and up to which value. Nothing for other views.
struct Range {
    const ViewRow* view = nullptr;
    double most = 0;
};
Range rangeOf(const State& state, std::size_t pane)
{
    const ViewRow* view = findView(state.panes[pane].view);
    return view && view->isHeat ? Range{view, double(heatRange(effectiveParameters(state, pane), *view))} : Range{};
}

QString viewText(const State& state, std::size_t pane)
{
    const ViewRow* view = findView(state.panes[pane].view);
    return view ? qt(view->label) : QString::fromStdString(state.panes[pane].view);
}

QString costText(const Measurement& measured, const ViewRow* view)
{
    QString text = QObject::tr("%1 fetches/px").arg(measured.meanFetches, 0, 'f', 1);
    if (!measured.shown || !view || !view->isAgainstExact) // these have no room for the time
        return measured.ms > 0. ? text + QObject::tr("   %1 ms").arg(measured.ms, 0, 'f', measured.ms < 9.95 ? 1 : 0) : text;
    const ErrorNumbers& error = measured.shown->error;
    const bool isShare = view->unit == "depth"; // of the depth, else texels or pixels
    text += QObject::tr("   RMSE %1, %2 % wrong").arg(error.rmse, 0, 'f', isShare ? 4 : 2).arg(100. * error.wrong, 0, 'f', 1);
    if (error.uncertain >= 0.001)
        text += QObject::tr(", %1 % unsure").arg(100. * error.uncertain, 0, 'f', 1);
    return text;
}
} // namespace

PaneOverlays::PaneOverlays(QWidget* viewport, Document& document, Wishes wishes)
    : m_viewport(viewport)
    , m_document(document)
    , m_wishes(std::move(wishes))
    , m_hint(new Hint(viewport))
{
}

void PaneOverlays::makeFor(std::size_t panes)
{
    while (m_captions.size() < panes) {
        const std::size_t pane = m_captions.size();
        m_captions.push_back(new PaneCaption(m_viewport));
        m_legends.push_back(new HeatLegend(m_viewport));
        const PaneCaption& caption = *m_captions.back();
        QObject::connect(m_legends.back(), &HeatLegend::fitWanted, m_viewport, [this, pane](double most) { fitRange(pane, most); });
        QObject::connect(caption.technique(), &QAbstractButton::clicked, m_viewport, [this, pane] { chooseTechnique(pane); });
        QObject::connect(caption.view(), &QAbstractButton::clicked, m_viewport, [this, pane] { chooseView(pane); });
        QObject::connect(caption.more(), &QAbstractButton::clicked, m_viewport, [this, pane] { chooseMore(pane); });
        QObject::connect(caption.technique(), &CaptionChoice::pulled, m_viewport,
            [this, pane] { dragTechnique(m_viewport, m_document.state().panes[pane].technique); });
        QObject::connect(caption.more(), &CaptionChoice::pulled, m_viewport, [this, pane] { dragPane(m_viewport, pane); });
    }
}

void PaneOverlays::update(const std::vector<std::optional<Measurement>>& measured, const MeshReference& reference, std::size_t activePane)
{
    const State& state = m_document.state();
    const std::size_t count = state.panes.size();
    makeFor(count);
    for (std::size_t pane = 0; pane < m_captions.size(); ++pane) {
        const Range range = pane < count ? rangeOf(state, pane) : Range{};
        m_captions[pane]->setVisible(pane < count);
        m_legends[pane]->setVisible(range.view != nullptr);
        if (pane >= count)
            continue;
        QString cost = pane < measured.size() && measured[pane] ? costText(*measured[pane], findView(state.panes[pane].view)) : QString();
        if (!cost.isEmpty() && reference.busy() && reference.isShown(pane) && !measured[pane]->shown)
            cost += QObject::tr("   tracing %1 %").arg(reference.percent());
        m_captions[pane]->show(
            count == 1 ? QString() : paneLetter(pane), techniqueText(state, pane), viewText(state, pane), cost, pane == activePane);
        if (range.view)
            m_legends[pane]->show(qt(range.view->label), qt(range.view->unit), range.most,
                pane < measured.size() && measured[pane] && measured[pane]->shown ? std::optional(measured[pane]->shown->heat)
                                                                                  : std::nullopt);
    }
}

void PaneOverlays::place(const std::vector<PaneArea>& areas, double pixelRatio)
{
    makeFor(areas.size());
    const auto toWindow = [pixelRatio](int pixels) { return int(pixels / pixelRatio); };
    for (std::size_t pane = 0; pane < areas.size(); ++pane) {
        const PaneArea& area = areas[pane];
        m_captions[pane]->setVisible(!area.isEmpty());
        if (area.isEmpty())
            m_legends[pane]->hide();
        const int left = toWindow(area.x) + kMargin;
        m_captions[pane]->move(left, toWindow(area.y) + kMargin);
        m_captions[pane]->fit(toWindow(area.width) - 2 * kMargin);
        HeatLegend& legend = *m_legends[pane];
        const int room = toWindow(area.width) - 2 * kMargin;
        legend.resize(std::clamp(room, 0, legend.sizeHint().width()), legend.sizeHint().height());
        legend.move(left, toWindow(area.y + area.height) - kMargin - legend.height());
    }
    placeHint();
}

// What a heat view shows up to is one value for all panes, so that they can be compared.
void PaneOverlays::fitRange(std::size_t pane, double most)
{
    const ViewRow* view = pane < m_document.state().panes.size() ? findView(m_document.state().panes[pane].view) : nullptr;
    if (!view || !view->range)
        return;
    const ParameterRow& row = kParameters[indexOf(view->range)];
    m_document.edit(
        QObject::tr("Fit the scale"), [&](State& state) { assign(state, row, std::clamp(float(most), row.min, row.max), kAllPanes); });
}

// In the middle, over the legends that stand at the lower edge.
void PaneOverlays::placeHint()
{
    const int width = m_viewport->width(), height = m_viewport->height();
    int floor = height;
    for (const HeatLegend* legend : m_legends)
        if (!legend->isHidden() && legend->geometry().bottom() > height - 2 * legend->height())
            floor = std::min(floor, legend->y());
    m_hint->move((width - m_hint->width()) / 2, floor - kMargin - m_hint->height());
}

void PaneOverlays::say(const QString& hint)
{
    m_hint->say(hint);
    placeHint();
}

namespace {
// A menu that deletes itself, shown under the button when it has been filled.
void popUpUnder(QWidget& button, const std::function<void(QMenu&)>& fill)
{
    auto* menu = new QMenu(&button);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fill(*menu);
    menu->popup(button.mapToGlobal(QPoint(0, kRowHeight + kGrid)));
}
} // namespace

// The document may have changed while the menu is open.
void PaneOverlays::chooseTechnique(std::size_t pane)
{
    m_wishes.pressed(pane);
    const auto choose = [this, pane](const TechniqueRow& row) { relievo::chooseTechnique(m_document, pane, row); };
    popUpUnder(
        *m_captions[pane]->technique(), [&](QMenu& menu) { fillTechniques(menu, m_document.state().panes[pane].technique, choose); });
}

void PaneOverlays::chooseMore(std::size_t pane)
{
    m_wishes.pressed(pane);
    popUpUnder(*m_captions[pane]->more(),
        [&](QMenu& menu) { fillPaneMenu(menu, m_document, pane, [this, pane] { m_wishes.ownValuesWanted(pane); }); });
}

void PaneOverlays::chooseView(std::size_t pane)
{
    m_wishes.pressed(pane);
    const auto choose = [this, pane](const ViewRow& row) {
        m_document.edit(QObject::tr("View %1").arg(qt(row.label)), [&](State& state) {
            if (pane < state.panes.size())
                state.panes[pane].view = row.key;
        });
    };
    popUpUnder(*m_captions[pane]->view(), [&](QMenu& menu) { fillViews(menu, m_document.state().panes[pane].view, choose); });
}

} // namespace relievo
