// A slider for a number with a default.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/widgets/slider_scale.h"
#include <QWidget>

namespace relievo {

// A slider over a SliderScale. Pressed on its handle it moves from there, pressed elsewhere it jumps. Ctrl is fine, Shift coarse,
// arrow keys step, a double click asks for the default. Back at the press it gives back exactly the value it began with.
class Slider : public QWidget {
    Q_OBJECT
public:
    Slider(const SliderScale& scale, double defaultValue, QWidget* parent = nullptr);
    double value() const { return m_value; }
    void setValue(double value); // without signals
    QPoint handle() const; // centre, px
    QSize sizeHint() const override { return {kShortest, 20}; }
    QSize minimumSizeHint() const override { return {kShortest, 20}; }
    static constexpr int kShortest = 120; // px

Q_SIGNALS:
    void pressed();
    void moved(double value);
    void released();
    void resumed(); // a second press follows at once: what comes up to `released` belongs to the gesture of the first
    void resetWanted();

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

private:
    void moveTo(double value);
    void endStepping();
    double span() const; // px that the handle can move
    SliderScale m_scale;
    double m_value, m_default;
    double m_startValue = 0, m_anchor = 0; // value and position [0, 1] when pressed
    double m_lastX = 0, m_pressX = 0; // px
    bool m_dragging = false, m_stepping = false; // by the mouse, by an arrow key that is down
};

} // namespace relievo
