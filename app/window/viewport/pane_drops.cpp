// What is dropped on a pane.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/pane_drops.h"
#include "app/window/document/document.h"
#include "app/window/panels/pane_menu.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/state/techniques.h"
#include <QDrag>
#include <QDropEvent>
#include <QMimeData>
#include <QPainter>
#include <QWidget>

namespace relievo {
namespace {
constexpr const char* kTechnique = "application/x-relievo-technique";
constexpr const char* kPane = "application/x-relievo-pane";

QMimeData* withBytes(const char* type, const QByteArray& bytes)
{
    auto* data = new QMimeData;
    data->setData(type, bytes);
    return data;
}

// A chip with the text hangs at the pointer.
void drag(QWidget* from, QMimeData* data, const QString& text)
{
    const qreal ratio = from->devicePixelRatioF();
    const QSize size(from->fontMetrics().horizontalAdvance(text) + 6 * kGrid, kRowHeight);
    QPixmap chip(size * ratio);
    chip.setDevicePixelRatio(ratio);
    chip.fill(Qt::transparent);
    QPainter painter(&chip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(from->font());
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent(from->palette()));
    painter.drawRoundedRect(QRect({}, size), 4, 4);
    painter.setPen(onAccent(from->palette()));
    painter.drawText(QRect({}, size), Qt::AlignCenter, text);
    painter.end();
    QDrag drag(from);
    drag.setMimeData(data);
    drag.setPixmap(chip);
    drag.setHotSpot({size.width() / 2, size.height() + 2 * kGrid});
    drag.exec(Qt::CopyAction);
}
} // namespace

QMimeData* draggedTechnique(const std::string& technique)
{
    return withBytes(kTechnique, QByteArray::fromStdString(technique));
}

QMimeData* draggedPane(std::size_t pane)
{
    return withBytes(kPane, QByteArray::number(qulonglong(pane)));
}

void dragTechnique(QWidget* from, const std::string& technique)
{
    if (const TechniqueRow* row = findTechnique(technique))
        drag(from, draggedTechnique(technique), qt(row->label));
}

void dragPane(QWidget* from, std::size_t pane)
{
    drag(from, draggedPane(pane), paneLetter(pane));
}

PaneDrops::PaneDrops(Document& document, std::function<std::size_t(QPointF)> paneAt, QWidget* widget)
    : QObject(widget)
    , m_document(document)
    , m_paneAt(std::move(paneAt))
{
    widget->setAcceptDrops(true);
    widget->installEventFilter(this);
}

bool PaneDrops::eventFilter(QObject*, QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove && event->type() != QEvent::Drop)
        return false;
    auto& dropped = *static_cast<QDropEvent*>(event);
    if (!dropped.mimeData()->hasFormat(kTechnique) && !dropped.mimeData()->hasFormat(kPane)) {
        event->ignore(); // the window may want it
        return true;
    }
    dropped.acceptProposedAction();
    if (event->type() == QEvent::Drop)
        drop(dropped);
    return true;
}

void PaneDrops::drop(const QDropEvent& event)
{
    const std::size_t onto = m_paneAt(event.position());
    const std::size_t count = m_document.state().panes.size();
    if (const TechniqueRow* row = findTechnique(event.mimeData()->data(kTechnique).toStdString()))
        return chooseTechnique(m_document, onto, *row);
    const std::size_t from = event.mimeData()->data(kPane).toULongLong();
    if (event.mimeData()->hasFormat(kPane) && from < count && from != onto)
        swapPanes(m_document, from, onto);
}

} // namespace relievo
