// Chooses how coarse the picture is drawn while the hand moves, from how long the last pictures took.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cmath>

namespace relievo {

// The scale is the share of the full resolution along each side, in steps of 1/12 from 1/6 to 1.
class FramePacer {
public:
    static constexpr double kTarget = 14.; // ms of drawing, so that with the window's own 20 ms a frame 25 a second are kept
    static constexpr int kSteps = 12, kLeast = 2;

    double scale() const { return double(m_step) / kSteps; }

    // The last picture was drawn at `drawnScale` and took `ms`.
    void took(double ms, double drawnScale)
    {
        const double full = std::max(0.01, ms) / (drawnScale * drawnScale); // drawing time goes with the number of pixels
        m_full = m_full > 0 ? 0.5 * (m_full + full) : full;
        const int wanted = std::clamp(int(std::floor(std::sqrt(kTarget / m_full) * kSteps)), kLeast, kSteps);
        // Finer only when it is well within reach: a picture that flickers between two scales is worse than a coarse one.
        if (wanted < m_step || wanted > m_step + 1)
            m_step = wanted < m_step ? wanted : wanted - 1;
    }

private:
    int m_step = 6;
    double m_full = 0; // ms of a full picture, smoothed
};

} // namespace relievo
