// Picking a point of the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/picking.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include <QEvent>
#include <QPainter>
#include <cmath>

namespace relievo {
namespace {
constexpr int kSide = 21; // px

// In pixels of the screen.
PaneArea areaOf(const QWidget& viewport, std::size_t pane, std::size_t panes)
{
    const double ratio = viewport.devicePixelRatioF();
    const auto areas = paneAreas(int(panes), int(std::lround(viewport.width() * ratio)), int(std::lround(viewport.height() * ratio)));
    return areas[std::min(pane, areas.size() - 1)];
}
} // namespace

PickMarker::PickMarker(QWidget* viewport) : QWidget(viewport)
{
    setObjectName("pick-marker");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(kSide, kSide);
    hide();
    viewport->installEventFilter(this);
}

void PickMarker::show(const std::optional<PickedPoint>& point, std::size_t panes)
{
    m_point = point;
    m_panes = panes;
    setVisible(point && point->pane < panes);
    place();
}

void PickMarker::place()
{
    if (!m_point || m_point->pane >= m_panes)
        return;
    const PaneArea area = areaOf(*parentWidget(), m_point->pane, m_panes);
    const QPointF place
        = QPointF(area.x + double(m_point->at.x) * area.width, area.y + double(m_point->at.y) * area.height) / devicePixelRatioF();
    move(place.toPoint() - QPoint(kSide / 2, kSide / 2));
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
    inspector.hide();
    auto* marker = new PickMarker(&viewport);
    const auto mark = [&inspector, &document, marker] {
        marker->show(inspector.isVisible() ? inspector.picked() : std::nullopt, document.state().panes.size());
    };
    QObject::connect(&inspector, &RayInspector::pointChanged, marker, mark);
    QObject::connect(&document, &Document::changed, marker, mark);
    QObject::connect(&viewport, &Viewport::clicked, &inspector, [&](std::size_t pane, QPointF position) {
        if (!inspector.isVisible())
            return;
        const PaneArea area = areaOf(viewport, pane, document.state().panes.size());
        const QPointF at = position * viewport.devicePixelRatioF() - QPointF(area.x, area.y);
        inspector.pick({pane, {float(at.x()) / float(area.width), float(at.y()) / float(area.height)}, area.aspect()});
    });
}

} // namespace relievo
