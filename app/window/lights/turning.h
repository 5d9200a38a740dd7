// Lights or camera that go around by themselves, once in Parameters::turnSeconds.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include <QElapsedTimer>
#include <QTimer>

namespace relievo {

class Viewport;

class Turning : public QObject {
    Q_OBJECT
public:
    Turning(Document& document, Viewport& viewport);
    void turnLights(bool on) { set(m_lights, on); }
    void turnCamera(bool on) { set(m_camera, on); } // of the active pane
    bool turnsLights() const { return m_lights; }
    bool turnsCamera() const { return m_camera; }

private:
    void set(bool& what, bool on);
    void tick();
    Document& m_document;
    Viewport& m_viewport;
    QTimer m_ticks; // does not run while nothing turns
    QElapsedTimer m_clock; // since the last tick
    bool m_lights = false, m_camera = false;
};

} // namespace relievo
