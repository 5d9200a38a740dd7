// What the controls share when they paint themselves.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/widgets/theme.h"
#include <QPainter>

namespace relievo {

struct SmoothPainter : QPainter {
    explicit SmoothPainter(QWidget* widget) : QPainter(widget) { setRenderHint(Antialiasing); }
};

// In the accent colour, when `widget` has the focus.
inline void focusFrame(QPainter& painter, const QWidget& widget, const QRectF& rect, qreal radius)
{
    if (!widget.hasFocus())
        return;
    painter.setPen(accent(widget.palette()));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(rect, radius, radius);
}

} // namespace relievo
