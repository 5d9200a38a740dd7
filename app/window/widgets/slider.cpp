// The slider: jumps, drags, fine and coarse, and the way back to exactly where it began.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/slider.h"
#include "app/window/widgets/theme.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {
constexpr double kHandle = 5; // radius, px
constexpr double kGrab = 9; // how near a press counts as on the handle, px

SliderScale::Grain grainOf(Qt::KeyboardModifiers keys)
{
    return keys & Qt::ControlModifier ? SliderScale::Grain::Fine
        : keys & Qt::ShiftModifier    ? SliderScale::Grain::Coarse
                                      : SliderScale::Grain::Normal;
}
} // namespace

Slider::Slider(const SliderScale& scale, double defaultValue, QWidget* parent)
    : QWidget(parent)
    , m_scale(scale)
    , m_value(defaultValue)
    , m_default(defaultValue)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
}

void Slider::setValue(double value)
{
    m_value = value;
    update();
}

double Slider::span() const
{
    return std::max(1., width() - 2 * (kHandle + 1));
}

QPoint Slider::handle() const
{
    return {int(std::lround(kHandle + 1 + span() * m_scale.position(m_value))), height() / 2};
}

void Slider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double y = height() / 2., left = kHandle + 1, x = left + span() * m_scale.position(m_value);
    const double origin = left + span() * m_scale.position(std::clamp(0., m_scale.min, m_scale.max)); // filled from zero
    const auto groove = [&](double from, double to, const QColor& color) {
        painter.setPen(QPen(color, 3, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(from, y), QPointF(to, y));
    };
    const double tick = left + span() * m_scale.position(m_default);
    painter.setPen(QPen(dimText(palette()), 1));
    painter.drawLine(QPointF(std::floor(tick) + 0.5, y + 6), QPointF(std::floor(tick) + 0.5, y + 8));
    groove(left, left + span(), raised(palette()));
    QColor filled = accent(palette());
    if (!underMouse() && !m_dragging)
        filled.setAlphaF(0.65f);
    groove(std::min(origin, x), std::max(origin, x), filled);
    painter.setPen(QPen(palette().color(QPalette::Window), 1));
    painter.setBrush(hasFocus() || m_dragging ? accent(palette()) : palette().color(QPalette::WindowText));
    painter.drawEllipse(QPointF(x, y), kHandle, kHandle);
}

void Slider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    m_dragging = true;
    m_startValue = m_value;
    m_pressX = m_lastX = event->position().x();
    m_anchor = m_scale.position(m_value);
    Q_EMIT pressed();
    if (std::abs(event->position().x() - handle().x()) > kGrab) {
        m_anchor = std::clamp((event->position().x() - kHandle - 1) / span(), 0., 1.);
        moveTo(m_scale.rounded(m_scale.value(m_anchor), grainOf(event->modifiers())));
        m_startValue = m_value;
    }
    update();
}

void Slider::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_dragging)
        return;
    const double x = event->position().x();
    const bool fine = event->modifiers() & Qt::ControlModifier;
    if (!fine && std::abs(x - m_pressX) < 0.5) { // back where it began
        m_anchor = m_scale.position(m_startValue);
        m_lastX = x;
        return moveTo(m_startValue);
    }
    m_anchor += (x - m_lastX) / span() * (fine ? 0.1 : 1.);
    m_lastX = x;
    moveTo(m_scale.rounded(m_scale.value(m_anchor), grainOf(event->modifiers())));
}

void Slider::mouseReleaseEvent(QMouseEvent* event)
{
    if (!m_dragging || event->button() != Qt::LeftButton)
        return;
    m_dragging = false;
    Q_EMIT released();
    update();
}

void Slider::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    Q_EMIT resumed(); // the first press may have jumped to a value that nobody wanted
    Q_EMIT resetWanted();
    Q_EMIT released();
}

void Slider::keyPressEvent(QKeyEvent* event)
{
    const bool up = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up;
    const bool down = event->key() == Qt::Key_Left || event->key() == Qt::Key_Down;
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)
        return Q_EMIT resetWanted();
    if (!up && !down)
        return QWidget::keyPressEvent(event);
    const auto grain = grainOf(event->modifiers());
    const double way = grain == SliderScale::Grain::Fine ? 0.001 : grain == SliderScale::Grain::Normal ? 0.01 : 0.05;
    double next = m_scale.rounded(m_scale.value(m_scale.position(m_value) + (up ? way : -way)), grain);
    if (m_scale.whole && next == m_value)
        next = std::clamp(m_value + (up ? 1 : -1), m_scale.min, m_scale.max);
    if (!std::exchange(m_stepping, true)) // its repeats are one gesture
        Q_EMIT pressed();
    moveTo(next);
}

void Slider::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat())
        endStepping();
    QWidget::keyReleaseEvent(event);
}

void Slider::focusOutEvent(QFocusEvent* event)
{
    endStepping();
    QWidget::focusOutEvent(event);
}

void Slider::endStepping()
{
    if (std::exchange(m_stepping, false))
        Q_EMIT released();
}

void Slider::moveTo(double value)
{
    if (value == m_value)
        return;
    m_value = value;
    update();
    Q_EMIT moved(value);
}

} // namespace relievo
