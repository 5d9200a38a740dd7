// A step of the turn, tick by tick: of the time that has passed, so that a slow picture turns as fast as a quick one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/lights/turning.h"
#include "app/window/viewport/viewport.h"
#include <cmath>

namespace relievo {
namespace {
constexpr int kTick = 33; // ms
} // namespace

Turning::Turning(Document& document, Viewport& viewport) : QObject(&viewport), m_document(document), m_viewport(viewport)
{
    m_ticks.setInterval(kTick);
    connect(&m_ticks, &QTimer::timeout, this, &Turning::tick);
}

void Turning::set(bool& what, bool on)
{
    what = on;
    if (!m_lights && !m_camera)
        return m_ticks.stop();
    if (!m_ticks.isActive()) {
        m_clock.start();
        m_ticks.start();
    }
}

// Neither is a step of undo: where the eye is, and the moment of an animation.
void Turning::tick()
{
    const std::size_t pane = std::size_t(m_viewport.activePane());
    const Parameters parameters = effectiveParameters(m_document.state(), pane);
    const double degrees = 360. * double(m_clock.restart()) * 1e-3 / double(parameters.turnSeconds);
    m_document.edit({}, [&](State& state) {
        if (m_lights)
            state.parameters.lightTurn = float(std::fmod(double(state.parameters.lightTurn) + degrees, 360.));
        if (m_camera) {
            Camera camera = cameraOf(state, pane);
            camera.yaw = float(std::remainder(double(camera.yaw) + degrees, 360.));
            setCameraOf(state, pane, camera);
        }
    });
    m_viewport.keepMoving();
}

} // namespace relievo
