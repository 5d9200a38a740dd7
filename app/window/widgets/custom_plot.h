// QCustomPlot's header is written in Qt's keywords, which this program does without: the State has slots of its own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QtCore/qtmetamacros.h>
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach
#include <QPalette>

namespace relievo {

// Axes, grid, legend and fonts as the window has them; again when the palette changes.
void applyLook(QCustomPlot& plot, const QPalette& colors);

} // namespace relievo
