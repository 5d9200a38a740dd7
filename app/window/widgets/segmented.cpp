// Buttons side by side that share a frame.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/painting.h"
#include <QHelpEvent>
#include <QToolTip>
#include <algorithm>

namespace relievo {
namespace {
constexpr int kSegmentPadding = 10; // px, left and right of a text
constexpr int kIconWidth = 28, kRowOfIcons = 224; // px; many icons move together, so that a panel holds them
} // namespace

Segmented::Segmented(const QVector<Item>& items, QWidget* parent) : QWidget(parent), m_items(items)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Segmented::setItems(const QVector<Item>& items)
{
    m_items = items;
    m_current = m_hovered = -1;
    updateGeometry();
    update();
}

void Segmented::setCurrent(int index)
{
    m_current = index;
    update();
}

int Segmented::width(int index) const
{
    const Item& item = m_items[index];
    return item.icon.isNull() ? fontMetrics().horizontalAdvance(item.text) + 2 * kSegmentPadding
                              : std::min(kIconWidth, kRowOfIcons / std::max(count(), 1));
}

QSize Segmented::sizeHint() const
{
    int total = 0;
    for (int i = 0; i < count(); ++i)
        total += width(i);
    return {total, kRowHeight};
}

QRect Segmented::segment(int index) const
{
    int x = 0;
    for (int i = 0; i < index; ++i)
        x += width(i);
    return {x, 0, width(index), height()};
}

int Segmented::at(QPoint point) const
{
    for (int i = 0; i < count(); ++i)
        if (segment(i).contains(point))
            return i;
    return -1;
}

void Segmented::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(lineColor(palette()));
    painter.setBrush(field(palette()));
    painter.drawRoundedRect(frame, 4, 4);
    for (int i = 0; i < count(); ++i) {
        const QRect part = segment(i);
        const bool on = i == m_current;
        if (on || i == m_hovered) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(on ? accent(palette()) : raised(palette()));
            painter.drawRoundedRect(part.adjusted(2, 2, -2, -2), 3, 3);
        }
        if (!m_items[i].icon.isNull()) {
            QPixmap pixels = m_items[i].icon.pixmap(QSize(16, 16), devicePixelRatio());
            if (on) {
                QPainter tint(&pixels);
                tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
                tint.fillRect(pixels.rect(), onAccent(palette()));
            }
            painter.drawPixmap(QRect(part.center() - QPoint(7, 7), QSize(16, 16)), pixels);
            continue;
        }
        painter.setPen(on ? onAccent(palette()) : isEnabled() ? palette().color(QPalette::WindowText) : dimText(palette()));
        painter.drawText(part, Qt::AlignCenter, m_items[i].text);
    }
    focusFrame(painter, *this, frame, 4);
}

void Segmented::mousePressEvent(QMouseEvent* event)
{
    const int index = at(event->position().toPoint());
    if (event->button() != Qt::LeftButton || index < 0)
        return;
    setCurrent(index);
    Q_EMIT chosen(index);
}

void Segmented::mouseMoveEvent(QMouseEvent* event)
{
    m_hovered = at(event->position().toPoint());
    update();
}

void Segmented::leaveEvent(QEvent*)
{
    m_hovered = -1;
    update();
}

void Segmented::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (step == 0)
        return QWidget::keyPressEvent(event);
    const int next = std::clamp(m_current + step, 0, count() - 1);
    if (next != m_current) {
        setCurrent(next);
        Q_EMIT chosen(next);
    }
}

bool Segmented::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int index = at(help->pos());
        if (index >= 0)
            QToolTip::showText(help->globalPos(), m_items[index].tip, this, segment(index));
        return true;
    }
    return QWidget::event(event);
}

} // namespace relievo
