// From gestures to edits of the document.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/navigator.h"
#include "app/window/document/editing.h"
#include "app/window/lights/light_places.h"
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <iterator>

namespace relievo {
namespace {
constexpr int kFlyTick = 16; // ms
constexpr double kFlySpeed = 1.; // distances to the target in a second
constexpr int kFlyKeys[] = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
} // namespace

Navigator::Navigator(Document& document, const Picture& picture, QWidget* widget)
    : QObject(widget)
    , m_document(document)
    , m_picture(picture)
    , m_widget(widget)
{
    widget->installEventFilter(this);
    connect(&m_flying, &QTimer::timeout, this, &Navigator::fly);
}

bool Navigator::eventFilter(QObject*, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        event->setAccepted(wantsKey(*static_cast<QKeyEvent*>(event)));
        return event->isAccepted();
    case QEvent::Enter:
        if (!qobject_cast<QLineEdit*>(QApplication::focusWidget()))
            m_widget->setFocus();
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        press(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseMove:
        move(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonRelease:
        release(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::Wheel:
        wheel(*static_cast<QWheelEvent*>(event));
        event->accept();
        return true;
    case QEvent::KeyPress:
        keyPressed(*static_cast<QKeyEvent*>(event));
        return static_cast<QKeyEvent*>(event)->isAutoRepeat();
    case QEvent::KeyRelease:
        keyReleased(*static_cast<QKeyEvent*>(event));
        return static_cast<QKeyEvent*>(event)->isAutoRepeat();
    case QEvent::FocusOut:
        letGo();
        return false;
    default:
        return false;
    }
}

// Single letters belong to the picture, not to menus, while the hand flies or turns the light.
bool Navigator::wantsKey(const QKeyEvent& event) const
{
    const int key = event.modifiers() & Qt::ControlModifier ? 0 : event.key();
    return key == Qt::Key_L || (m_drag == Gesture::Fly && std::ranges::find(kFlyKeys, key) != std::end(kFlyKeys));
}

void Navigator::moveCamera(const Camera& camera)
{
    m_document.edit({}, [&](State& state) { setCameraOf(state, m_pane, camera); });
}

void Navigator::press(const QMouseEvent& event)
{
    m_widget->setFocus();
    const std::size_t pane = m_picture.paneAt(event.position());
    Q_EMIT pressed(pane);
    if (m_drag || !m_picture.isReady())
        return;
    m_pane = pane;
    m_drag = gestureFor(event.button(), event.modifiers(), m_keys.contains(Qt::Key_L));
    m_dragButton = event.button();
    m_last = m_pressedAt = event.position();
    if (m_drag == Gesture::Light)
        m_document.beginGesture();
    if (m_drag == Gesture::Fly)
        Q_EMIT hint(tr("W A S D  fly    Q E  down and up"));
}

void Navigator::move(const QMouseEvent& event)
{
    if (!m_drag)
        return;
    const QPointF moved = event.position() - m_last;
    m_last = event.position();
    const Camera& camera = cameraOf(m_document.state(), m_pane);
    const PaneView view = m_picture.view(m_pane);
    switch (*m_drag) {
    case Gesture::Orbit:
        return moveCamera(orbited(camera, moved.x(), moved.y()));
    case Gesture::Pan:
        return moveCamera(panned(camera, view.camera, moved.x(), moved.y(), view.height));
    case Gesture::Zoom:
        return moveCamera(zoomed(camera, view.camera, (moved.x() - moved.y()) / 40.));
    case Gesture::Fly:
        return moveCamera(lookedAround(camera, view.camera, moved.x(), moved.y()));
    case Gesture::Light:
        return turn(moved.x(), moved.y());
    }
}

void Navigator::turn(double dx, double dy)
{
    m_document.edit(tr("Turn light"), [&](State& state) {
        Parameters lit = effectiveParameters(state, m_pane);
        turnLight(lit, kLights.front(), dx, dy);
        const bool own = m_pane < state.panes.size() && state.panes[m_pane].camera; // an unlinked pane's light is its own too
        for (const char* key : {"lightYaw", "lightPitch"})
            assign(state, *findParameter(key), get(lit, *findParameter(key)), own ? Scope(m_pane) : kAllPanes);
    });
    const Parameters lit = effectiveParameters(m_document.state(), m_pane);
    Q_EMIT hint(
        tr("Light  direction %1\u00b0  height %2\u00b0").arg(double(lit.lightYaw), 0, 'f', 0).arg(double(lit.lightPitch), 0, 'f', 0));
}

void Navigator::release(const QMouseEvent& event)
{
    if (!m_drag || event.button() != m_dragButton)
        return;
    const bool still = (event.position() - m_pressedAt).manhattanLength() < 3 && m_drag == Gesture::Orbit;
    endDrag();
    if (still)
        Q_EMIT clicked(m_pane, event.position());
}

void Navigator::endDrag()
{
    const bool light = m_drag == Gesture::Light;
    m_drag.reset();
    m_flying.stop();
    Q_EMIT hint({});
    if (light)
        m_document.endGesture();
    Q_EMIT ended(!light);
}

void Navigator::wheel(const QWheelEvent& event)
{
    if (!m_picture.isReady() || event.angleDelta().y() == 0)
        return;
    if (!m_drag)
        m_pane = m_picture.paneAt(event.position());
    moveCamera(zoomed(cameraOf(m_document.state(), m_pane), m_picture.view(m_pane).camera, event.angleDelta().y() / 120.));
    Q_EMIT wheeled();
}

void Navigator::keyPressed(const QKeyEvent& event)
{
    if (!m_drag)
        moveByKey(event.key());
    if (event.isAutoRepeat())
        return;
    m_keys.insert(event.key());
    if (event.key() == Qt::Key_L && !m_drag)
        Q_EMIT hint(tr("Drag to turn the light"));
    if (m_drag == Gesture::Fly && !m_flying.isActive()) {
        m_flyClock.start();
        m_flying.start(kFlyTick);
    }
}

void Navigator::moveByKey(int key)
{
    const auto row = std::ranges::find(kCameraKeys, key, [](const CameraKeyRow& one) { return int(one.key); });
    if (row == kCameraKeys.end() || !m_picture.isReady())
        return;
    m_pane = m_picture.activePane();
    const Camera turned = orbited(cameraOf(m_document.state(), m_pane), row->right, row->down);
    moveCamera(row->closer == 0. ? turned : zoomed(turned, m_picture.view(m_pane).camera, row->closer));
    Q_EMIT wheeled();
}

void Navigator::keyReleased(const QKeyEvent& event)
{
    if (event.isAutoRepeat())
        return;
    m_keys.remove(event.key());
    if (event.key() == Qt::Key_L && !m_drag)
        Q_EMIT hint({});
}

void Navigator::letGo()
{
    m_keys.clear();
    if (m_drag)
        endDrag();
    Q_EMIT hint({});
}

void Navigator::fly()
{
    const auto along = [&](int plus, int minus) { return double(m_keys.contains(plus)) - double(m_keys.contains(minus)); };
    const double right = along(Qt::Key_D, Qt::Key_A), up = along(Qt::Key_E, Qt::Key_Q), forward = along(Qt::Key_W, Qt::Key_S);
    const double seconds = double(m_flyClock.restart()) * 1e-3;
    if (right == 0 && up == 0 && forward == 0)
        return m_flying.stop();
    const CameraView view = m_picture.view(m_pane).camera;
    const double step = seconds * kFlySpeed * double(view.distance);
    moveCamera(flown(cameraOf(m_document.state(), m_pane), view, right * step, up * step, forward * step));
}

} // namespace relievo
