// Play, pause and scrub the animation of a mesh that moves; hidden for any other.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace relievo {

class Slider;

class AnimationBar : public QWidget {
    Q_OBJECT
public:
    AnimationBar(Document& document, Assets& assets, QWidget* parent = nullptr);
    bool isPlaying() const { return m_ticks.isActive(); }
    void setPlaying(bool playing);

private:
    double seconds() const; // length of the clip shown, at least a millisecond
    void setTime(double time);
    void refresh();
    void rebuild();

    Document& m_document;
    Assets& m_assets;
    QToolButton* m_play;
    QComboBox* m_clips;
    QWidget* m_slot; // the slider's place: its range is the clip's length
    Slider* m_slider = nullptr;
    QLabel* m_label;
    QTimer m_ticks;
    QElapsedTimer m_clock; // since the last tick
    std::shared_ptr<const Mesh> m_mesh; // that the bar was built for
    int m_clip = -1;
};

} // namespace relievo
