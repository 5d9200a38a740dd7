// Axes, plot and the line above them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/speed_page.h"
#include "app/window/decide/speed_plot.h"
#include "app/window/document/editing.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/elided_label.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/analysis/report.h"
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kNarrowHead = 360; // px

template <class Rows> Segmented* axis(const Rows& rows, const char* name)
{
    QVector<Segmented::Item> items;
    for (const FigureRow& row : rows)
        items << Segmented::Item{qt(row.label), qt(row.unit), {}};
    auto* choice = new Segmented(items);
    choice->setObjectName(name);
    choice->setCurrent(0);
    return choice;
}

} // namespace

void applySetting(Document& document, std::size_t pane, const SearchSetting& setting)
{
    document.edit(qt(setting.label), [&](State& state) {
        const Scope scope = state.panes.size() > 1 ? Scope(pane) : kAllPanes;
        for (const ParameterRow& row : kParameters)
            if (const Value value = get(setting.parameters, row);
                searchesBy(*setting.technique, row) && value != get(effectiveParameters(state, pane), row))
                assign(state, row, value, scope);
        state.panes[pane].technique = setting.technique->key;
    });
}

SpeedPage::SpeedPage(Document& document, const Assets& assets, const Viewport& viewport)
    : m_document(document)
    , m_viewport(viewport)
    , m_sweep(document, assets, viewport)
    , m_cost(axis(kCostFigures, "cost"))
    , m_error(axis(kErrorFigures, "error"))
    , m_line(new ElidedLabel)
    , m_head(new QBoxLayout(QBoxLayout::LeftToRight))
    , m_plot(new SpeedPlot)
{
    m_line->setObjectName("line");
    setRole(*m_line, "dim");
    m_head->setSpacing(2 * kGrid);
    m_head->addWidget(m_cost, 0, Qt::AlignLeft);
    m_head->addWidget(m_error, 0, Qt::AlignLeft);
    m_head->addWidget(m_line, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGrid);
    layout->addLayout(m_head);
    layout->addWidget(m_plot, 1);
    connect(&m_sweep, &LiveSweep::changed, this, &SpeedPage::refresh);
    connect(m_cost, &Segmented::chosen, this, &SpeedPage::refresh);
    connect(m_error, &Segmented::chosen, this, &SpeedPage::refresh);
    connect(m_plot, &SpeedPlot::hovered, this, &SpeedPage::say);
    connect(m_plot, &SpeedPlot::chosen, this, &SpeedPage::choose);
}

void SpeedPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_sweep.run(true);
}

void SpeedPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_head->setDirection(width() < kNarrowHead ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void SpeedPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_sweep.run(false);
}

void SpeedPage::refresh()
{
    m_plot->show(m_sweep.points(), kCostFigures[std::size_t(m_cost->current())], kErrorFigures[std::size_t(m_error->current())]);
    say(-1);
}

void SpeedPage::say(int point)
{
    if (point < 0 || point >= int(m_sweep.points().size())) {
        const QString rest = tr("Lower left is better; click a point to use it");
        return m_line->setFullText(m_sweep.note().isEmpty() ? rest : m_sweep.note());
    }
    const MeasuredSetting& at = m_sweep.points()[std::size_t(point)];
    const QString text = tr("%1 fetches, %2 B; depth %3 %, wrong %4 %, %5 px")
                             .arg(qt(figure(at.errors.meanFetches)), qt(figure(at.errors.meanBytes)), qt(figure(100. * at.errors.rmse)),
                                 qt(figure(100. * at.errors.wrongShare())), qt(figure(at.errors.rmsePixels)));
    m_line->setFullText(at.isCoarse ? tr("%1 (coarse)").arg(text) : text);
}

void SpeedPage::choose(int point)
{
    if (point < int(m_sweep.points().size()))
        applySetting(m_document, std::size_t(m_viewport.activePane()), m_sweep.points()[std::size_t(point)].setting);
}

} // namespace relievo
