// What programs share that measure or draw the editor's window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <algorithm>
#include <functional>

namespace relievo {

// OpenGL 4.1 as the editor asks for it, and settings of their own. Before the application is made.
inline void prepareWindows()
{
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setOrganizationName("relievo-bench");
}

// Lets the window work until `done` or for `limit` ms. ms of the longest turn of the event loop.
inline double workUntil(const std::function<bool()>& done, int limit = 300000)
{
    double longest = 0.;
    QElapsedTimer whole, turn;
    for (whole.start(); !done() && whole.elapsed() < limit;) {
        turn.start();
        QApplication::processEvents(QEventLoop::AllEvents, 1);
        longest = std::max(longest, double(turn.nsecsElapsed()) * 1e-6);
    }
    return longest;
}

// Of the left button.
inline void mouse(QWidget& widget, QEvent::Type type, QPointF at)
{
    const Qt::MouseButtons buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

} // namespace relievo
