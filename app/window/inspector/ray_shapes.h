// How the papers draw the steps of a search.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/widgets/custom_plot.h"
#include "core/trace/recorded_steps.h"
#include <QPolygonF>

namespace relievo {

QCPScatterStyle::ScatterShape shapeOf(StepKind kind);

// What proved that the leap between two points of the ray was empty: the cone that stands on the relief below its start (at that height),
// the box, the ball around the start. Empty for steps that prove nothing.
QPolygonF emptySpace(StepKind kind, QPointF from, QPointF to, double heightBefore);

QByteArray svgOf(QCustomPlot& plot, const QString& title);

} // namespace relievo
