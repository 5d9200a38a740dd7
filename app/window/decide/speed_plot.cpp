// Drawing speed against error.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/speed_plot.h"
#include "app/window/widgets/custom_plot.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr double kReach = 14.; // px around a point that are its

QCPScatterStyle::ScatterShape shapeOf(const TechniqueRow& technique)
{
    return technique.isExact                 ? QCPScatterStyle::ssDiamond
        : !technique.accelerationMap.empty() ? QCPScatterStyle::ssTriangle
        : technique.searches                 ? QCPScatterStyle::ssDisc
                                             : QCPScatterStyle::ssSquare;
}

void logarithmic(QCPAxis& axis)
{
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
    axis.setNumberFormat("g");
    axis.setNumberPrecision(3);
}
} // namespace

SpeedPlot::SpeedPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    setObjectName("speed-plot");
    setAccessibleName(tr("Cost and error of each technique and setting"));
    setMinimumSize(200, 100);
    m_plot->setMouseTracking(true);
    m_plot->setInteractions({QCP::iRangeDrag, QCP::iRangeZoom});
    logarithmic(*m_plot->xAxis);
    logarithmic(*m_plot->yAxis);
    connect(m_plot, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) { point(event->position()); });
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, [this](QMouseEvent* event) {
        if (nearest(event->position()) < 0) {
            setRanges();
            m_plot->replot(QCustomPlot::rpQueuedReplot);
        }
    });
    connect(m_plot, &QCustomPlot::mouseRelease, this, [this](QMouseEvent* event) {
        const int at = nearest(event->position());
        if (event->button() == Qt::LeftButton && at >= 0 && at == m_hovered)
            Q_EMIT chosen(at);
    });
    applyLook(*m_plot, palette());
}

void SpeedPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    applyLook(*m_plot, palette());
    rebuild();
}

// Neighbours in the table are far apart in hue.
QColor SpeedPlot::colorOf(const TechniqueRow& technique) const
{
    const auto row = std::ranges::find(kTechniques, technique.key, &TechniqueRow::key) - kTechniques.begin();
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    return QColor::fromHsl(int(row * 137) % 360, 150, dark ? 150 : 95);
}

CostAndError SpeedPlot::place(std::size_t point) const
{
    return {std::max(m_values[point].cost, m_leastCost), std::max(m_values[point].error, m_leastError)};
}

// Half of the least that is more than nothing.
double SpeedPlot::leastOf(double none, double CostAndError::*value) const
{
    double least = 1e9;
    for (const CostAndError& at : m_values)
        least = at.*value > none ? std::min(least, at.*value) : least;
    return least < 1e9 ? 0.5 * least : none;
}

void SpeedPlot::show(const std::vector<MeasuredSetting>& points, const FigureRow& cost, const FigureRow& error)
{
    const bool sameAxes = m_plot->xAxis->label() == qt(cost.unit) && m_plot->yAxis->label() == qt(error.unit);
    const bool wasEmpty = m_points.empty();
    m_points = points;
    m_values.clear();
    for (const MeasuredSetting& point : m_points)
        m_values.push_back({cost.of(point.errors), point.errors.invalid ? std::nan("") : error.of(point.errors)});
    m_front = paretoFront(m_values);
    m_plot->xAxis->setLabel(qt(cost.unit));
    m_plot->yAxis->setLabel(qt(error.unit));
    m_hovered = -1;
    const double lowCost = m_leastCost, lowError = m_leastError;
    m_leastCost = leastOf(cost.none, &CostAndError::cost);
    m_leastError = leastOf(error.none, &CostAndError::error);
    rebuild();
    if (!sameAxes || wasEmpty || lowCost != m_leastCost || lowError != m_leastError)
        setRanges();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SpeedPlot::setRanges()
{
    double mostCost = 2. * m_leastCost, mostError = 2. * m_leastError;
    for (const CostAndError& value : m_values) {
        mostCost = std::isfinite(value.cost) ? std::max(mostCost, value.cost) : mostCost;
        mostError = std::isfinite(value.error) ? std::max(mostError, value.error) : mostError;
    }
    m_plot->xAxis->setRange(0.8 * m_leastCost, 1.4 * mostCost);
    m_plot->yAxis->setRange(0.6 * m_leastError, 1.8 * mostError);
}

void SpeedPlot::rebuild()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_mark = nullptr, m_name = nullptr;
    std::map<std::string, std::vector<std::size_t>> series;
    for (std::size_t i = 0; i < m_points.size(); ++i)
        if (std::isfinite(m_values[i].error))
            series[m_points[i].setting.series].push_back(i);
    drawFront();
    for (auto& [name, points] : series) {
        std::ranges::sort(points, {}, [this](std::size_t i) { return m_values[i].cost; });
        drawSeries(points);
    }
    drawPresent();
    m_mark = new QCPItemTracer(m_plot);
    m_mark->setStyle(QCPItemTracer::tsCircle);
    m_mark->setSize(14);
    m_mark->setPen(QPen(palette().color(QPalette::Text), 1.5));
    m_mark->setBrush(Qt::NoBrush);
    m_mark->setVisible(false);
    m_name = new QCPItemText(m_plot);
    m_name->setFont(smallFont());
    m_name->setColor(palette().color(QPalette::Text));
    m_name->setBrush(raised(palette()));
    m_name->setPadding({6, 2, 6, 2});
    m_name->setVisible(false);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// Coarse points are hollow.
void SpeedPlot::drawSeries(const std::vector<std::size_t>& points)
{
    const TechniqueRow& technique = *m_points[points.front()].setting.technique;
    const QColor color = colorOf(technique);
    QColor faint = color;
    faint.setAlpha(110);
    for (const bool coarse : {true, false}) {
        QVector<double> x, y;
        for (const std::size_t i : points)
            if (m_points[i].isCoarse == coarse)
                x << place(i).cost, y << place(i).error;
        if (x.isEmpty())
            continue;
        QCPGraph* dots = m_plot->addGraph();
        dots->setData(x, y);
        dots->setPen(QPen(faint, 1));
        dots->setScatterStyle({shapeOf(technique), QPen(color, 1.25), coarse ? QBrush(Qt::NoBrush) : QBrush(color), 6.});
    }
}

void SpeedPlot::drawFront()
{
    QVector<double> x, y;
    for (const std::size_t i : m_front)
        x << place(i).cost, y << place(i).error;
    QCPGraph* line = m_plot->addGraph();
    line->setData(x, y);
    line->setLineStyle(QCPGraph::lsStepLeft);
    QColor color = accent(palette());
    color.setAlpha(170);
    line->setPen(QPen(color, 3));
}

void SpeedPlot::drawPresent()
{
    for (std::size_t i = 0; i < m_points.size(); ++i)
        if (m_points[i].isPresent && std::isfinite(m_values[i].error)) {
            QCPGraph* ring = m_plot->addGraph();
            ring->setData({place(i).cost}, {place(i).error});
            ring->setLineStyle(QCPGraph::lsNone);
            ring->setScatterStyle({QCPScatterStyle::ssCircle, QPen(palette().color(QPalette::Text), 2), QBrush(Qt::NoBrush), 13.});
        }
}

QPointF SpeedPlot::placeOf(std::size_t point) const
{
    const CostAndError at = place(point);
    return {m_plot->xAxis->coordToPixel(at.cost), m_plot->yAxis->coordToPixel(at.error)};
}

int SpeedPlot::nearest(QPointF at) const
{
    int found = -1;
    double best = kReach;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const QPointF away = placeOf(i) - at;
        const double distance = std::hypot(away.x(), away.y());
        if (std::isfinite(m_values[i].error) && distance < best)
            best = distance, found = int(i);
    }
    return found;
}

void SpeedPlot::point(QPointF at)
{
    const int found = nearest(at);
    if (found == m_hovered)
        return;
    m_hovered = found;
    m_plot->setCursor(found >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    m_mark->setVisible(found >= 0);
    m_name->setVisible(found >= 0);
    if (found >= 0) {
        const CostAndError place = this->place(std::size_t(found));
        m_mark->position->setCoords(place.cost, place.error);
        const QPointF pixel = placeOf(std::size_t(found));
        const bool left = pixel.x() > 0.6 * m_plot->width();
        m_name->setPositionAlignment((left ? Qt::AlignRight : Qt::AlignLeft) | (pixel.y() < 40 ? Qt::AlignTop : Qt::AlignBottom));
        m_name->position->setType(QCPItemPosition::ptAbsolute);
        m_name->position->setCoords(pixel + QPointF(left ? -10 : 10, pixel.y() < 40 ? 8 : -8));
        m_name->setText(qt(m_points[std::size_t(found)].setting.label));
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    Q_EMIT hovered(found);
}

} // namespace relievo
