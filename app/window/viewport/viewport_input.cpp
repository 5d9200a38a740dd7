// The hand in the picture: mouse, wheel and keys become camera moves and light turns.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/technique_bar.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWheelEvent>

namespace relievo {
namespace {
constexpr int kFlyTick = 16; // ms
constexpr double kFlySpeed = 1.; // distances to the target in a second
constexpr int kFlyKeys[] = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
} // namespace

void Viewport::moveCamera(const Camera& camera)
{
    m_document.edit({}, [&](State& state) { state.camera = camera; });
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    setFocus();
    if (paneCount() > 1)
        setActivePane(event->position().x() * devicePixelRatioF() >= area(1).x ? 1 : 0);
    if (m_drag || !m_assets.ready())
        return;
    m_drag = gestureFor(event->button(), event->modifiers(), m_keys.contains(Qt::Key_L));
    m_dragButton = event->button();
    m_last = event->position();
    if (m_drag == Gesture::Light)
        m_document.beginGesture();
    if (m_drag == Gesture::Fly)
        m_hint->say(tr("W A S D  fly    Q E  down and up"));
    placeOverlays();
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_drag)
        return;
    const QPointF moved = event->position() - m_last;
    m_last = event->position();
    const Camera& camera = m_document.state().camera;
    switch (*m_drag) {
    case Gesture::Orbit:
        return moveCamera(orbited(camera, moved.x(), moved.y()));
    case Gesture::Pan:
        return moveCamera(panned(camera, sight(), moved.x(), moved.y(), height()));
    case Gesture::Zoom:
        return moveCamera(zoomed(camera, sight(), (moved.x() - moved.y()) / 40.));
    case Gesture::Fly:
        return moveCamera(lookedAround(camera, sight(), moved.x(), moved.y()));
    case Gesture::Light:
        m_document.edit(tr("Turn light"), [&](State& state) { turnLight(state.parameters, moved.x(), moved.y()); });
        const Parameters& p = m_document.state().parameters;
        m_hint->say(
            tr("Light  direction %1\u00b0  height %2\u00b0").arg(double(p.lightYaw), 0, 'f', 0).arg(double(p.lightPitch), 0, 'f', 0));
        placeOverlays();
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_drag && event->button() == m_dragButton)
        endDrag();
}

void Viewport::endDrag()
{
    const bool light = m_drag == Gesture::Light;
    m_drag.reset();
    m_flying.stop();
    m_hint->say({});
    if (light)
        m_document.endGesture();
    else if (m_moving)
        refresh(false);
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (!m_assets.ready() || event->angleDelta().y() == 0)
        return;
    moveCamera(zoomed(m_document.state().camera, sight(), event->angleDelta().y() / 120.));
    refresh(true);
    event->accept();
}

// Single letters belong to the picture, not to menus, while the hand flies or turns the light.
bool Viewport::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if ((m_drag == Gesture::Fly && std::find(std::begin(kFlyKeys), std::end(kFlyKeys), key) != std::end(kFlyKeys))
            || key == Qt::Key_L) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::Enter && !qobject_cast<QLineEdit*>(QApplication::focusWidget()))
        setFocus();
    return QOpenGLWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat())
        return;
    m_keys.insert(event->key());
    if (event->key() == Qt::Key_L && !m_drag) {
        m_hint->say(tr("Drag to turn the light"));
        placeOverlays();
    }
    if (m_drag == Gesture::Fly && !m_flying.isActive()) {
        m_flyClock.start();
        m_flying.start(kFlyTick);
    }
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat())
        return;
    m_keys.remove(event->key());
    if (event->key() == Qt::Key_L && !m_drag)
        m_hint->say({});
    QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    m_keys.clear();
    if (m_drag)
        endDrag();
    m_hint->say({});
    QOpenGLWidget::focusOutEvent(event);
}

// The document may have changed while the menu is open.
void Viewport::chooseTechnique(int pane)
{
    setActivePane(pane);
    const std::size_t index = std::size_t(m_activePane);
    popUpTechniques(this, m_captions[index]->mapToGlobal(QPoint(0, kRowHeight + kGrid)), m_document.state().panes[index].technique,
        [this, index](const TechniqueRow& row) {
            m_document.edit(tr("Technique %1").arg(qt(row.label)), [&](State& state) {
                if (index < state.panes.size())
                    state.panes[index].technique = row.key;
            });
        });
}

void Viewport::fly()
{
    const auto along = [&](int plus, int minus) { return double(m_keys.contains(plus)) - double(m_keys.contains(minus)); };
    const double right = along(Qt::Key_D, Qt::Key_A), up = along(Qt::Key_E, Qt::Key_Q), forward = along(Qt::Key_W, Qt::Key_S);
    const double seconds = double(m_flyClock.restart()) * 1e-3;
    if (right == 0 && up == 0 && forward == 0)
        return m_flying.stop();
    const CameraView view = sight();
    const double step = seconds * kFlySpeed * double(view.distance);
    moveCamera(flown(m_document.state().camera, view, right * step, up * step, forward * step));
}

} // namespace relievo
