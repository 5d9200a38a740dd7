// Picking a point of the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/picking.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include <QEvent>
#include <QPainter>

namespace relievo {
namespace {
constexpr int kSide = 21; // px
} // namespace

PickMarker::PickMarker(Viewport* viewport) : QWidget(viewport), m_viewport(*viewport)
{
    setObjectName("pick-marker");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(kSide, kSide);
    hide();
    viewport->installEventFilter(this);
}

void PickMarker::show(const std::optional<PickedPoint>& point)
{
    m_point = point;
    place();
}

void PickMarker::place()
{
    const auto areas = m_viewport.places().areas();
    setVisible(m_point && m_point->pane < areas.size() && !areas[m_point->pane].isEmpty());
    if (isHidden())
        return;
    move(m_viewport.places().fromPicture(m_point->pane, m_point->at).toPoint() - QPoint(kSide / 2, kSide / 2));
}

bool PickMarker::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void PickMarker::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(kSide / 2., kSide / 2.);
    for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 150), 3.5), std::pair(accent(palette()).lighter(120), 1.5)}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(middle, 6., 6.);
        for (const QPointF way : {QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(0, -1)})
            painter.drawLine(middle + way * 4., middle + way * 8.5);
    }
}

void connectPicking(RayInspector& inspector, Viewport& viewport, Document& document)
{
    auto* marker = new PickMarker(&viewport);
    const auto mark = [&inspector, &document, marker] { marker->show(inspector.isVisible() ? inspector.picked() : std::nullopt); };
    QObject::connect(&inspector, &RayInspector::pointChanged, marker, mark);
    QObject::connect(&document, &Document::changed, marker, mark);
    QObject::connect(&viewport.places(), &PanePlaces::arranged, marker, mark);
    QObject::connect(&viewport.places(), &PanePlaces::composed, marker, mark);
    QObject::connect(&viewport, &Viewport::clicked, &inspector, [&inspector, &viewport](std::size_t pane, QPointF position) {
        if (!inspector.isVisible())
            return;
        inspector.pick({pane, viewport.places().toPicture(pane, position), viewport.places().areas()[pane].aspect()});
    });
}

} // namespace relievo
