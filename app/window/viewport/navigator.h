// The hand in the picture: mouse, wheel and keys become camera moves and light turns.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "app/window/viewport/navigation.h"
#include <QElapsedTimer>
#include <QPointF>
#include <QSet>
#include <QTimer>
#include <functional>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace relievo {

// Moves the camera (or turns the light) of the pane that a gesture began in: its own when it is unlinked, else the shared one.
class Navigator : public QObject {
    Q_OBJECT
public:
    // A pane as it is seen now.
    struct PaneView {
        CameraView camera;
        double height; // pixels of the window
    };
    // What the navigator asks of the picture.
    struct Picture {
        std::function<bool()> isReady; // there is something to move around
        std::function<std::size_t(QPointF position)> paneAt;
        std::function<PaneView(std::size_t pane)> view;
        std::function<std::size_t()> activePane; // what keys move
    };
    // Hears the events of `widget`, which owns it.
    Navigator(Document& document, const Picture& picture, QWidget* widget);

    bool isDragging() const { return m_drag.has_value(); }

Q_SIGNALS:
    void pressed(std::size_t pane);
    void wheeled();
    void hint(const QString& text); // "" when there is none any more
    void ended(bool movedCamera); // of a gesture
    void clicked(std::size_t pane, QPointF position); // the left button, and the hand lay still

protected:
    bool eventFilter(QObject* widget, QEvent* event) override;

private:
    bool wantsKey(const QKeyEvent& event) const;
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    void keyPressed(const QKeyEvent& event);
    void moveByKey(int key);
    void keyReleased(const QKeyEvent& event);
    void letGo(); // the focus is lost
    void endDrag();
    void fly();
    void moveCamera(const Camera& camera);
    void turn(double dx, double dy);
    Document& m_document;
    Picture m_picture;
    QWidget* m_widget;
    std::optional<Gesture> m_drag;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    std::size_t m_pane = 0; // that the gesture began in
    QPointF m_last, m_pressedAt;
    QSet<int> m_keys; // held down
    QTimer m_flying;
    QElapsedTimer m_flyClock;
};

} // namespace relievo
