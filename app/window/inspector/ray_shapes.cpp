// Shapes of the cross-section.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/ray_shapes.h"
#include <QBuffer>
#include <QSvgGenerator>
#include <cmath>
#include <numbers>

namespace relievo {

QCPScatterStyle::ScatterShape shapeOf(StepKind kind)
{
    switch (kind) {
    case StepKind::Halving:
        return QCPScatterStyle::ssDiamond;
    case StepKind::Secant:
        return QCPScatterStyle::ssTriangle;
    case StepKind::Cell:
    case StepKind::Box:
        return QCPScatterStyle::ssSquare;
    default:
        return QCPScatterStyle::ssDisc;
    }
}

QPolygonF emptySpace(StepKind kind, QPointF from, QPointF to, double heightBefore)
{
    const double across = to.x() - from.x();
    QPolygonF shape;
    switch (kind) {
    case StepKind::Cone:
        return {{QPointF(from.x() - across, to.y()), QPointF(from.x(), heightBefore), to}};
    case StepKind::Box:
    case StepKind::Cell:
        return {{from, QPointF(to.x(), from.y()), to, QPointF(from.x(), to.y()), from}};
    case StepKind::Ball:
        for (int i = 0; i <= 48; ++i) {
            const double angle = i * std::numbers::pi / 24;
            shape << from
                    + QPointF(std::numbers::sqrt2 * across * std::cos(angle), std::numbers::sqrt2 * (from.y() - to.y()) * std::sin(angle));
        }
        return shape;
    default:
        return shape;
    }
}

QByteArray svgOf(QCustomPlot& plot, const QString& title)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plot.size());
    generator.setViewBox(plot.rect());
    generator.setTitle(title);
    QCPPainter painter;
    painter.begin(&generator);
    painter.setMode(QCPPainter::pmVectorized);
    plot.toPainter(&painter, plot.width(), plot.height());
    painter.end();
    return bytes;
}

} // namespace relievo
