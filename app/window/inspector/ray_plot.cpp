// Drawing a cross-section.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/ray_plot.h"
#include "app/window/inspector/ray_shapes.h"
#include "app/window/inspector/step_table.h"
#include "app/window/widgets/theme.h"
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {
constexpr int kSurfacePoints = 1024;
} // namespace

QColor RayPlot::colorOf(std::size_t pane, const QPalette& palette)
{
    constexpr int hues[] = {30, 200, 140, 330, 60, 270}; // told apart by most eyes, the accent not among them
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    return QColor::fromHsl(hues[pane % std::size(hues)], 200, dark ? 150 : 90);
}

RayPlot::RayPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    setObjectName("ray-plot");
    setAccessibleName(tr("Cross-section of the relief along the ray"));
    setMinimumSize(220, 120);
    m_plot->setInteractions(QCP::Interactions(QCP::iRangeDrag) | QCP::iRangeZoom);
    m_plot->setNoAntialiasingOnDrag(true);
    m_plot->xAxis->setLabel(tr("texels along the ray"));
    m_plot->yAxis->setLabel(tr("height"));
    m_plot->xAxis->setSubTicks(false);
    m_plot->yAxis->setSubTicks(false);
    m_plot->setAutoAddPlottableToLegend(false);
    m_plot->legend->setIconSize(10, 8);
    m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, &RayPlot::showAll);
    applyLook(*m_plot, palette());
}

void RayPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    applyLook(*m_plot, palette());
    rebuild();
}

void RayPlot::show(const std::vector<Shown>& rays, const HeightField* field, std::size_t chosen)
{
    m_rays = rays;
    m_field = field ? std::optional(*field) : std::nullopt;
    m_chosen = std::min(chosen, rays.empty() ? 0 : rays.size() - 1);
    m_marked = -1;
    rebuild();
    showAll();
}

void RayPlot::rebuild()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_plot->legend->setVisible(false);
    m_mark = nullptr;
    if (!m_rays.empty() && m_field) {
        drawSurface();
        m_plot->legend->setVisible(m_rays.size() > 1);
        for (std::size_t i = 0; i < m_rays.size(); ++i)
            if (i != m_chosen)
                drawSteps(m_rays[i], colorOf(i, palette()), false);
        drawSteps(m_rays[m_chosen], colorOf(m_chosen, palette()), true);
        drawExact(m_rays[m_chosen].ray);
        m_mark = new QCPItemTracer(m_plot);
        m_mark->setStyle(QCPItemTracer::tsCircle);
        m_mark->setSize(14);
        m_mark->setPen(QPen(palette().color(QPalette::Text), 1.5));
        m_mark->setBrush(Qt::NoBrush);
        mark(m_marked);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// Straight down there is no way along: t stands for it.
QPointF RayPlot::at(const RayInspection& ray, double t) const
{
    const double texels = glm::length(ray.ray.duv * glm::dvec2(m_field->width(), m_field->height()));
    return {texels > 1e-3 ? t * texels : t, 1. - t};
}

void RayPlot::drawSurface()
{
    const RayInspection& ray = m_rays[m_chosen].ray;
    QVector<double> x, height;
    for (int i = -kSurfacePoints / 20; i <= kSurfacePoints * 21 / 20; ++i) {
        const double t = double(i) / kSurfacePoints;
        x << at(ray, t).x();
        height << double(m_field->at(glm::vec2(ray.ray.uv + t * ray.ray.duv)));
    }
    QCPGraph* surface = m_plot->addGraph();
    surface->setData(x, height, true);
    surface->setPen(QPen(palette().color(QPalette::Text), 1.5));
    QColor fill = palette().color(QPalette::Text);
    fill.setAlpha(40);
    surface->setBrush(fill);
    auto* way = new QCPItemStraightLine(m_plot);
    way->point1->setCoords(at(ray, 0.));
    way->point2->setCoords(at(ray, 1.));
    way->setPen(QPen(dimText(palette()), 1, Qt::DashLine));
}

void RayPlot::drawArea(const RayInspection& ray, const SearchStep& step, double heightBefore, const QColor& color)
{
    const QPolygonF shape = emptySpace(step.kind, at(ray, step.from), at(ray, step.to), heightBefore);
    if (shape.isEmpty())
        return;
    QVector<double> x, y;
    for (const QPointF& point : shape)
        x << point.x(), y << point.y();
    auto* area = new QCPCurve(m_plot->xAxis, m_plot->yAxis);
    area->setData(x, y);
    QColor line = color, fill = color;
    line.setAlpha(150);
    fill.setAlpha(28);
    area->setPen(QPen(line, 1));
    area->setBrush(fill);
}

void RayPlot::drawSteps(const Shown& shown, const QColor& color, bool chosen)
{
    QVector<double> stemX, stemY;
    std::map<StepKind, QVector<QPointF>> points;
    double heightBefore = double(m_field->at(glm::vec2(shown.ray.ray.uv)));
    for (const SearchStep& step : shown.ray.steps) {
        const QPointF end = at(shown.ray, readAt(shown.ray, step));
        points[step.kind] << end;
        if (chosen && step.to > step.from)
            drawArea(shown.ray, step, heightBefore, color);
        if (chosen && step.kind == StepKind::Linear) {
            stemX << end.x() << end.x() << std::nan("");
            stemY << end.y() << step.height << std::nan("");
        }
        heightBefore = step.height;
    }
    if (!stemX.isEmpty()) {
        auto* stems = new QCPCurve(m_plot->xAxis, m_plot->yAxis);
        stems->setData(stemX, stemY);
        QColor line = color;
        line.setAlpha(110);
        stems->setPen(QPen(line, 1));
    }
    for (const auto& [kind, places] : points) {
        QCPGraph* dots = m_plot->addGraph();
        QVector<double> x, y;
        for (const QPointF& place : places)
            x << place.x(), y << place.y();
        dots->setData(x, y);
        dots->setLineStyle(QCPGraph::lsNone);
        dots->setScatterStyle({shapeOf(kind), color, kind == StepKind::Halving ? QBrush(Qt::NoBrush) : QBrush(color), chosen ? 6. : 4.});
        if (&places == &points.begin()->second) { // the others have the same colour
            dots->setName(shown.name);
            dots->addToLegend();
        }
    }
}

void RayPlot::drawExact(const RayInspection& ray)
{
    const auto cross = [&](double t, QCPScatterStyle::ScatterShape shape, const QColor& color, double size) {
        const QPointF place = at(ray, t);
        QCPGraph* dot = m_plot->addGraph();
        dot->setData({place.x()}, {place.y()});
        dot->setLineStyle(QCPGraph::lsNone);
        dot->setScatterStyle({shape, QPen(color, 2), QBrush(Qt::NoBrush), size});
    };
    cross(ray.exact, QCPScatterStyle::ssPlusCircle, accent(palette()), 14);
    cross(ray.hit.t, QCPScatterStyle::ssCross, colorOf(m_chosen, palette()), 11);
}

void RayPlot::mark(int step)
{
    m_marked = step;
    if (!m_mark)
        return;
    const std::vector<SearchStep>& steps = m_rays[m_chosen].ray.steps;
    m_mark->setVisible(step >= 0 && step < int(steps.size()));
    if (m_mark->visible())
        m_mark->position->setCoords(at(m_rays[m_chosen].ray, steps[std::size_t(step)].to));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void RayPlot::showAll()
{
    if (m_rays.empty() || !m_field)
        return;
    double last = 0., lowest = 1.;
    for (const Shown& shown : m_rays)
        last = std::max({last, shown.ray.hit.t, shown.ray.exact, 0.05});
    for (const SearchStep& step : m_rays[m_chosen].ray.steps) // cones are seen down to where they stand
        lowest = step.kind == StepKind::Cone ? std::min(lowest, step.height) : lowest;
    const double end = at(m_rays[m_chosen].ray, std::min(1.15 * last, 1.05)).x();
    m_plot->xAxis->setRange(-0.05 * end, end);
    m_plot->yAxis->setRange(std::max(std::min(1. - 1.25 * last, lowest - 0.05), -0.05), 1.05);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

QByteArray RayPlot::svg()
{
    return svgOf(*m_plot, tr("Cross-section of the relief along a ray"));
}

} // namespace relievo
