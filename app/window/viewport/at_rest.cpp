// Working while the hand rests.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/at_rest.h"
#include "app/window/compare/pane_places.h"
#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <utility>

namespace relievo {
namespace {
constexpr int kMeasureDelay = 60; // ms from the full picture to the counting of fetches
constexpr double kSlice = 15; // ms of smoothing between two looks at what the hand does
} // namespace

AtRest::AtRest(std::function<ShownScene()> scene, PanePlaces& places, QOpenGLWidget* viewport)
    : QObject(viewport)
    , m_scene(std::move(scene))
    , m_places(places)
    , m_viewport(viewport)
{
    for (QTimer* timer : {&m_filling, &m_measuring, &m_smoothing})
        timer->setSingleShot(true);
    connect(&m_filling, &QTimer::timeout, this, &AtRest::fill);
    connect(&m_measuring, &QTimer::timeout, this, &AtRest::measure);
    connect(&m_smoothing, &QTimer::timeout, this, &AtRest::smooth);
}

void AtRest::start(PanePictures& pictures, bool isFull)
{
    m_pictures = &pictures;
    m_counting.clear();
    m_filled = 0.;
    isFull ? m_measuring.start(kMeasureDelay) : m_filling.start(0);
}

void AtRest::stop()
{
    m_filling.stop();
    m_measuring.stop();
    m_smoothing.stop();
}

void AtRest::fill()
{
    QElapsedTimer clock;
    clock.start();
    m_viewport->makeCurrent();
    const bool isWhole = m_pictures->fillSlice(m_scene(), m_places.areas(), kSlice);
    m_viewport->doneCurrent();
    m_filled += double(clock.nsecsElapsed()) * 1e-6;
    if (!isWhole)
        return m_filling.start(0);
    Q_EMIT filled(m_filled);
}

// Counts the fetches of what is shown, pane by pane, then smooths the edges.
void AtRest::measure()
{
    const std::vector<PaneArea> areas = m_places.areas();
    m_viewport->makeCurrent();
    if (m_counting.size() < areas.size())
        m_counting.push_back(m_pictures->measure(m_scene(), m_counting.size(), areas[m_counting.size()]));
    const bool isWhole = m_counting.size() >= areas.size();
    if (isWhole)
        m_places.compare(*m_pictures);
    m_viewport->doneCurrent();
    if (!isWhole)
        return m_measuring.start(0);
    m_measured = std::exchange(m_counting, {});
    m_samples.begin();
    m_smoothing.start(0);
    Q_EMIT counted();
}

// A slice more of the shifted pictures; the hand is heard between any two.
void AtRest::smooth()
{
    m_viewport->makeCurrent();
    const bool isWhole = m_pictures->addSlice(m_scene(), m_places.areas(), kSlice);
    const int samples = m_pictures->samples();
    if (!isWhole || !m_samples.isEnough(samples))
        m_smoothing.start(0);
    else
        m_places.compare(*m_pictures); // the smooth ones
    m_viewport->doneCurrent();
    if (isWhole && m_samples.isShown(samples))
        Q_EMIT smoothed();
}

} // namespace relievo
