// Enlarging what is drawn.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/pixel_zoom.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace relievo {

PixelZoom::PixelZoom(std::function<PaneArea(QPointF)> areaAt, QWidget* widget) : QObject(widget), m_areaAt(std::move(areaAt))
{
    widget->installEventFilter(this);
}

// The corner lies on a pixel, so that squares are whole.
void PixelZoom::moveTo(glm::vec2 corner, const PaneArea& area)
{
    const glm::vec2 size(std::max(area.width, 1), std::max(area.height, 1));
    const glm::vec2 last = glm::floor(size * (1.f - 1.f / float(m_factor)));
    m_corner = glm::clamp(glm::round(corner * size), glm::vec2(0.f), last) / size;
}

void PixelZoom::set(int factor, glm::vec2 about, const PaneArea& area)
{
    const glm::vec2 pixel = inPicture(about);
    m_factor = std::clamp(factor, 1, kMost);
    moveTo(pixel - about / float(m_factor), area);
    Q_EMIT changed();
}

void PixelZoom::reset()
{
    if (m_factor == 1)
        return;
    m_factor = 1, m_corner = glm::vec2(0.f);
    m_pulledFrom.reset();
    Q_EMIT changed();
}

bool PixelZoom::wheel(QPointF position, int delta)
{
    const PaneArea area = m_areaAt(position);
    const double ratio = static_cast<QWidget*>(parent())->devicePixelRatioF();
    const glm::vec2 about((position.x() * ratio - area.x) / area.width, (position.y() * ratio - area.y) / area.height);
    if (delta != 0)
        set(delta > 0 ? m_factor * 2 : m_factor / 2, glm::clamp(about, 0.f, 1.f), area);
    return true;
}

bool PixelZoom::eventFilter(QObject*, QEvent* event)
{
    if (event->type() == QEvent::Wheel) {
        const auto& turned = *static_cast<QWheelEvent*>(event);
        return turned.modifiers() & Qt::ControlModifier && wheel(turned.position(), turned.angleDelta().y());
    }
    if (m_factor == 1)
        return false;
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        reset();
        return true;
    }
    const bool isMouse
        = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonRelease;
    if (!isMouse)
        return false;
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress && mouse.button() == Qt::MiddleButton) {
        m_pulledFrom = mouse.position();
        return true;
    }
    if (!m_pulledFrom)
        return false;
    if (event->type() == QEvent::MouseButtonRelease && mouse.button() == Qt::MiddleButton) {
        m_pulledFrom.reset();
        return true;
    }
    const PaneArea area = m_areaAt(mouse.position());
    const double scale = static_cast<QWidget*>(parent())->devicePixelRatioF() / m_factor;
    const QPointF moved = (mouse.position() - *m_pulledFrom) * scale; // pixels of the picture
    const glm::vec2 pixels(std::round(moved.x()), std::round(moved.y()));
    if (pixels == glm::vec2(0.f))
        return true; // until it is a whole one
    *m_pulledFrom += QPointF(double(pixels.x), double(pixels.y)) / scale;
    moveTo(m_corner - pixels / glm::vec2(area.width, area.height), area);
    Q_EMIT changed();
    return true;
}

} // namespace relievo
