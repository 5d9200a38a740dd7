// Painting a switch and a swatch.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/switch.h"
#include "app/window/widgets/painting.h"

namespace relievo {

Switch::Switch(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Switch::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    painter.setOpacity(isEnabled() ? 1. : 0.4);
    const QRectF track(1, height() / 2. - 7, 28, 14);
    painter.setPen(isChecked() ? accent(palette()) : lineColor(palette()));
    painter.setBrush(isChecked() ? accent(palette()) : field(palette()));
    painter.drawRoundedRect(track.adjusted(0.5, 0.5, -0.5, -0.5), 7, 7);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChecked() ? onAccent(palette()) : underMouse() ? palette().color(QPalette::WindowText) : dimText(palette()));
    painter.drawEllipse(QPointF(isChecked() ? track.right() - 7 : track.left() + 7, track.center().y()), 4, 4);
    focusFrame(painter, *this, track.adjusted(-0.5, -0.5, 0.5, 0.5), 7.5);
}

Swatch::Swatch(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void Swatch::setColor(const QColor& color)
{
    m_color = color;
    update();
}

void Swatch::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    painter.setPen(lineColor(palette()));
    painter.setBrush(m_color);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    focusFrame(painter, *this, QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4);
}

} // namespace relievo
