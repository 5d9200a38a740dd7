// What is done while the picture rests: drawn in full and its edges smoothed, slice by slice; fetches counted, errors measured.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_pictures.h"
#include "app/window/viewport/samples_at_rest.h"
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

class QOpenGLWidget;

namespace relievo {

class PanePlaces;

// Of a viewport, which owns it.
class AtRest : public QObject {
    Q_OBJECT
public:
    AtRest(std::function<ShownScene()> scene, PanePlaces& places, QOpenGLWidget* viewport);

    void start(PanePictures& pictures, bool isFull); // soon; isFull: they are drawn in full resolution already
    void stop(); // they change
    bool isActive() const { return m_filling.isActive() || m_measuring.isActive() || m_smoothing.isActive(); }
    const std::vector<std::optional<Measurement>>& measured() const { return m_measured; } // of the panes
    void forget() { m_measured.clear(); } // it was of other pictures
    const SamplesAtRest& samples() const { return m_samples; }
    void want(int samples) { m_samples.want(samples); }

Q_SIGNALS:
    // The pictures have full resolution, which took `ms` of drawing; nothing more is done until they are started so.
    void filled(double ms);
    void counted(); // measured() is of what is shown
    void smoothed(); // what is shown is smoother

private:
    void fill();
    void measure();
    void smooth();
    std::function<ShownScene()> m_scene;
    PanePlaces& m_places;
    QOpenGLWidget* m_viewport;
    PanePictures* m_pictures = nullptr;
    SamplesAtRest m_samples;
    double m_filled = 0.; // ms spent on it
    QTimer m_filling, m_measuring, m_smoothing;
    std::vector<std::optional<Measurement>> m_measured, m_counting; // the second as far as it is
};

} // namespace relievo
