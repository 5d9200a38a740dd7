// Showing where a file can be dropped.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/drop_frame.h"
#include "app/window/widgets/dropping.h"
#include "app/window/widgets/theme.h"
#include <QApplication>
#include <QPainter>

namespace relievo {

DropFrame::DropFrame(QWidget* picture, QWidget* window) : QWidget(window), m_picture(picture)
{
    setObjectName("drop-frame");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    qApp->installEventFilter(this);
}

// Widgets that take drops themselves hear of a drag before the window does: it leaves one and enters the next.
bool DropFrame::eventFilter(QObject* object, QEvent* event)
{
    const auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || widget->window() != window())
        return false;
    if (event->type() == QEvent::DragEnter && !draggedFile(*static_cast<QDropEvent*>(event)).isEmpty()) {
        setGeometry(QRect(m_picture->mapTo(window(), QPoint(0, 0)), m_picture->size()));
        show();
        raise();
    } else if (event->type() == QEvent::Drop || event->type() == QEvent::DragLeave) {
        hide();
    }
    return false;
}

void DropFrame::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(accent(palette()), 3));
    painter.drawRoundedRect(QRectF(rect()).adjusted(4, 4, -4, -4), 6, 6);
    const QString text = tr("Drop to open it here");
    const QSize size(painter.fontMetrics().horizontalAdvance(text) + 32, 32);
    const QRect chip(QPoint((width() - size.width()) / 2, height() - size.height() - 16), size);
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent(palette()));
    painter.drawRoundedRect(chip, 4, 4);
    painter.setPen(onAccent(palette()));
    painter.drawText(chip, Qt::AlignCenter, text);
}

} // namespace relievo
