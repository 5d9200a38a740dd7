// Measuring and drawing over the distance.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/distance_page.h"
#include "app/window/decide/live_sweep.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/custom_plot.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/analysis/report.h"
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRestOfDistances = 250; // ms without a change until it is measured
constexpr int kNarrowPlot = 360; // px

} // namespace

DistancePage::DistancePage(const Document& document, const Assets& assets, const Viewport& viewport)
    : m_document(document)
    , m_assets(assets)
    , m_viewport(viewport)
    , m_background(this)
    , m_line(new QLabel)
    , m_plot(new QCustomPlot)
{
    setObjectName("distance");
    m_line->setObjectName("suggestion");
    m_line->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGrid);
    layout->addWidget(m_line);
    layout->addWidget(m_plot, 1);
    m_plot->setMinimumSize(200, 90);
    m_plot->setAccessibleName(tr("Pixels by which the relief and its errors shift what is seen, over the distance"));
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
        axis->setNumberFormat("g");
        axis->setNumberPrecision(3);
    }
    m_plot->xAxis->setLabel(tr("distance of the eye, m"));
    m_plot->yAxis->setLabel(tr("shift, pixels"));
    m_plot->plotLayout()->addElement(0, 1, m_plot->legend); // beside the curves, not over them
    m_plot->plotLayout()->setColumnStretchFactor(1, 0.001);
    m_plot->legend->setVisible(true);
    m_plot->legend->setIconSize(14, 8);
    applyLook(*m_plot, palette());
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestOfDistances);
    connect(&m_rest, &QTimer::timeout, this, &DistancePage::measure);
    connect(&document, &Document::changed, this, &DistancePage::stir);
    connect(&assets, &Assets::resourcesChanged, this, &DistancePage::stir);
    connect(&viewport, &Viewport::activePaneChanged, this, &DistancePage::stir);
}

void DistancePage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_rest.start();
}

void DistancePage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_rest.stop();
    m_background.cancel();
}

void DistancePage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    applyLook(*m_plot, palette());
    draw();
}

void DistancePage::stir()
{
    if (!isVisible())
        return;
    m_background.cancel();
    m_rest.start();
}

void DistancePage::measure()
{
    if (m_document.inGesture())
        return m_rest.start();
    const Resources& resources = m_assets.resources();
    if (!m_assets.ready() || !m_assets.upToDate() || !resources.material->height) {
        take({});
        return m_line->setText(
            m_assets.ready() && m_assets.upToDate() ? tr("There is no height map to search.") : tr("Waits for the files."));
    }
    const std::size_t pane = std::size_t(m_viewport.activePane());
    const State state = ofPane(m_document.state(), pane);
    const SearchSetting setting = plainSetting(*findTechnique(state.panes.front().technique), state.parameters);
    const ViewGrid grid = gridOf(m_viewport, pane, 1);
    Answer answer{setting.label, {}, double(physicalDepth(state.parameters, resources.mesh->metresPerUV)),
        double(cameraOnto(*resources.mesh, state.camera, grid.aspect).distance), {double(state.camera.fov), double(grid.height)}};
    m_background.start([this, answer, setting, heights = resources.material->height->withWrap(state.parameters.wrap),
                           midlevel = double(state.parameters.midlevel)](const Progress& progress) mutable -> Background::Then {
        const auto figures = figuresByAngle(setting, heights, midlevel, progress);
        if (!figures)
            return [this, why = QString::fromStdString(message(figures.error()))] { m_line->setText(why); };
        answer.figures = *figures;
        return [this, answer] { take(answer); };
    });
}

void DistancePage::take(const Answer& answer)
{
    m_answer = answer;
    draw();
    if (m_answer.figures.empty())
        return;
    const double within = distanceOfErrors(m_answer.figures, m_answer.depth, m_answer.lens);
    const auto& [nearest, steepest] = std::pair(m_answer.figures.front(), m_answer.figures.back());
    const QString cost = tr("%1: %2 fetches at %3\u00b0, %4 at %5\u00b0.")
                             .arg(qt(m_answer.setting), qt(figure(nearest.errors.meanFetches)), QString::number(nearest.angle),
                                 qt(figure(steepest.errors.meanFetches)), QString::number(steepest.angle));
    const QString errors
        = within > 0.001 ? tr(" Its error is below a pixel from %1 m on.").arg(qt(figure(within))) : tr(" It has no error.");
    const QString fade = tr("From <b>%1 m</b> on the relief shifts what is seen by less than a pixel: fade to bump there.")
                             .arg(qt(figure(fadeDistance())));
    m_line->setText(fade + ' ' + cost.toHtmlEscaped() + errors);
}

void DistancePage::draw()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_plot->legend->setVisible(width() >= kNarrowPlot);
    const double fade = fadeDistance();
    if (!m_answer.figures.empty() && fade > 0.) {
        m_from = 0.2 * std::min(fade, m_answer.distance);
        m_to = 5. * std::max(fade, m_answer.distance);
        for (std::size_t i = 0; i < m_answer.figures.size(); ++i)
            curve(m_answer.figures[i], i);
        auto* one = new QCPItemStraightLine(m_plot); // a pixel
        one->point1->setCoords(m_from, 1.);
        one->point2->setCoords(m_to, 1.);
        one->setPen(QPen(palette().color(QPalette::Text), 1));
        upright(m_answer.distance, tr("now"), Qt::SolidLine);
        upright(fade, tr("fade"), Qt::DashLine);
        m_plot->xAxis->setRange(m_from, m_to);
        m_plot->yAxis->setRange(0.02, 2. * std::max(1., fade / m_from));
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// The relief's own shift dashed, the error's drawn through; straight lines, as both axes are logarithmic.
void DistancePage::curve(const AngleFigures& at, std::size_t index)
{
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    const QColor color = QColor::fromHsl(int(200 + 65 * index) % 360, 160, dark ? 150 : 95);
    for (const bool isError : {false, true}) {
        const double share = isError ? at.errors.rmse : at.parallax;
        if (share <= 0.)
            continue;
        QCPGraph* line = m_plot->addGraph();
        line->setData({m_from, m_to},
            {shiftInPixels(share, m_answer.depth, at.angle, m_answer.lens, m_from),
                shiftInPixels(share, m_answer.depth, at.angle, m_answer.lens, m_to)});
        line->setPen(QPen(color, isError ? 2. : 1.25, isError ? Qt::SolidLine : Qt::DashLine));
        line->setName(isError ? tr("error at %1\u00b0").arg(at.angle) : tr("relief at %1\u00b0").arg(at.angle));
    }
}

void DistancePage::upright(double distance, const QString& text, Qt::PenStyle style)
{
    auto* line = new QCPItemStraightLine(m_plot);
    line->point1->setCoords(distance, 0.1);
    line->point2->setCoords(distance, 1.);
    line->setPen(QPen(accent(palette()), 1.5, style));
    auto* label = new QCPItemText(m_plot);
    label->position->setTypeX(QCPItemPosition::ptPlotCoords);
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(distance, 0.02);
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setText(' ' + text);
    label->setFont(smallFont());
    label->setColor(palette().color(QPalette::Text));
}

} // namespace relievo
