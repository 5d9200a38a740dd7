// How many shifted pictures are averaged while the hand rests: the user's choice, and what time allows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>

namespace relievo {

class SamplesAtRest {
public:
    static constexpr int kLeast = 16, kUsual = 64, kMost = 256;

    SamplesAtRest(); // as the settings have it
    int wanted() const { return m_wanted; }
    void want(int samples); // from kLeast to kMost; kept in the settings

    void begin() { m_since.start(); } // the hand rests now
    bool isEnough(int samples) const; // those wanted, or the least after ten seconds, or none where no pane is smoothed
    bool isShown(int samples) const; // the last ones, and before them those that are twice as many as the ones shown

private:
    QElapsedTimer m_since;
    int m_wanted;
};

} // namespace relievo
