// Looking at the pixels of the pictures: the same part of each, enlarged.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_layout.h"
#include <QObject>
#include <QPointF>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>

namespace relievo {

// Hears the wheel with Ctrl, and while something is enlarged the middle button and Escape, of a widget, which owns it.
class PixelZoom : public QObject {
    Q_OBJECT
public:
    inline static constexpr int kMost = 32; // pixels of the screen a pixel of the picture

    // areaAt: of the picture at a point of the widget, pixels of the screen.
    PixelZoom(std::function<PaneArea(QPointF position)> areaAt, QWidget* widget);

    int factor() const { return m_factor; } // a power of two; 1: as drawn
    glm::vec2 corner() const { return m_corner; } // of what is seen, shares of the pictures from their upper left corners
    // From a share of a picture's place to one of the picture, and back.
    glm::vec2 inPicture(glm::vec2 place) const { return m_corner + place / float(m_factor); }
    glm::vec2 inPlace(glm::vec2 picture) const { return (picture - m_corner) * float(m_factor); }
    void set(int factor, glm::vec2 about, const PaneArea& area); // about: a share of the place that keeps its pixel
    void reset();

Q_SIGNALS:
    void changed();

protected:
    bool eventFilter(QObject* widget, QEvent* event) override;

private:
    bool wheel(QPointF position, int delta);
    void moveTo(glm::vec2 corner, const PaneArea& area);
    std::function<PaneArea(QPointF)> m_areaAt;
    int m_factor = 1;
    glm::vec2 m_corner{0.f};
    std::optional<QPointF> m_pulledFrom;
};

} // namespace relievo
