// The animation bar.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/animation_bar.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/slider.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/mesh/animation/pose.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace relievo {

AnimationBar::AnimationBar(Document& document, Assets& assets, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_play(new QToolButton)
    , m_clips(new ChoiceList)
    , m_slot(new QWidget)
    , m_label(new QLabel)
{
    setObjectName("animation");
    m_play->setObjectName("play");
    m_play->setIconSize({16, 16});
    m_play->setFixedSize(28, 28);
    m_clips->setToolTip(tr("Animation"));
    m_label->setMinimumWidth(m_label->fontMetrics().horizontalAdvance("000.00 / 000.00 s"));
    m_label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* slot = new QHBoxLayout(m_slot);
    slot->setContentsMargins(0, 0, 0, 0);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 2, 12, 2);
    line->setSpacing(8);
    line->addWidget(m_play);
    line->addWidget(m_clips);
    line->addWidget(m_slot, 1);
    line->addWidget(m_label);
    m_ticks.setInterval(33);
    connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(m_clips, &QComboBox::activated, this, [this](int clip) {
        m_document.edit(tr("Animation"), [clip](State& state) { state.parameters.clip = clip, state.parameters.time = 0.f; });
    });
    connect(&m_ticks, &QTimer::timeout, this,
        [this] { setTime(std::fmod(double(m_document.state().parameters.time) + double(m_clock.restart()) / 1000., seconds())); });
    connect(&assets, &Assets::resourcesChanged, this, &AnimationBar::refresh);
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & (Changes(Change::Parameters) | Change::Moment))
            refresh();
    });
    setPlaying(false);
    refresh();
}

void AnimationBar::setPlaying(bool playing)
{
    m_play->setIcon(icon(playing ? "pause" : "play"));
    m_play->setToolTip(playing ? tr("Pause") : tr("Play"));
    m_clock.start();
    playing ? m_ticks.start() : m_ticks.stop();
}

double AnimationBar::seconds() const
{
    const int clip = m_document.state().parameters.clip;
    const bool known = m_mesh && m_mesh->deformation && clip < int(m_mesh->deformation->clips.size());
    return std::max(known ? double(m_mesh->deformation->clips[std::size_t(clip)].seconds) : 0., 1e-3);
}

void AnimationBar::setTime(double time)
{
    m_document.edit(tr("Time"), [time](State& state) { state.parameters.time = float(time); });
}

// Only while no hand is on the slider: another mesh or clip brings another range.
void AnimationBar::rebuild()
{
    const int clip = m_document.state().parameters.clip;
    if (m_mesh == m_assets.resources().mesh && clip == m_clip && m_slider)
        return;
    m_mesh = m_assets.resources().mesh;
    m_clip = clip;
    m_clips->clear();
    for (const AnimationClip& each : m_mesh->deformation->clips)
        m_clips->addItem(qt(each.name));
    m_clips->setVisible(m_clips->count() > 1);
    m_clips->setCurrentIndex(std::min(clip, m_clips->count() - 1));
    delete m_slider;
    m_slider = new Slider({.min = 0., .max = seconds()}, 0.);
    m_slider->setObjectName("time");
    m_slot->layout()->addWidget(m_slider);
    connect(m_slider, &Slider::pressed, this, [this] { setPlaying(false); });
    connect(m_slider, &Slider::moved, this, &AnimationBar::setTime);
    connect(m_slider, &Slider::resetWanted, this, [this] { setTime(0.); });
}

void AnimationBar::refresh()
{
    const std::shared_ptr<const Mesh>& mesh = m_assets.resources().mesh;
    const bool moves = mesh && mesh->deformation && !mesh->deformation->clips.empty();
    setVisible(moves);
    if (!moves) {
        setPlaying(false);
        return;
    }
    rebuild();
    const double time = std::fmod(double(m_document.state().parameters.time), seconds());
    m_slider->setValue(time);
    m_label->setText(tr("%1 / %2 s").arg(time, 0, 'f', 2).arg(seconds(), 0, 'f', 2));
}

} // namespace relievo
