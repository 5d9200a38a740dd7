// What lies over the picture: captions, the legend of heat maps and hints. None takes the mouse from the picture but the captions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <QAbstractButton>
#include <QString>
#include <QWidget>

namespace relievo {

// "relief 8-32+6": the technique and what decides its cost, for the caption of a pane.
QString techniqueText(const State& state, std::size_t pane);

QString paneLetter(std::size_t pane); // "A" for the first

// A chip in a pane's corner: letter (of several panes), technique, and measured cost. Pressed, it offers the techniques.
class PaneCaption : public QAbstractButton {
    Q_OBJECT
public:
    explicit PaneCaption(QWidget* parent);
    void show(const QString& letter, const QString& technique, const QString& cost, bool active);
    void fit(int room); // px; where it is too narrow for all, the cost goes first, then the technique is cut
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    int wide(bool withCost) const; // px
    QString m_letter, m_technique, m_cost;
    bool m_active = false;
};

// The colours of a heat view with numbers and unit.
class HeatLegend : public QWidget {
    Q_OBJECT
public:
    explicit HeatLegend(QWidget* parent);
    void show(const QString& title, const QString& unit, double max);
    double max() const { return m_max; } // at the bright end
    QString caption() const; // what the numbers are
    QSize sizeHint() const override { return {268, 60}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString m_title, m_unit;
    double m_max = 1;
};

// One line of text in the middle of the lower edge, shown for as long as it matters.
class Hint : public QWidget {
    Q_OBJECT
public:
    explicit Hint(QWidget* parent);
    void say(const QString& text);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString m_text;
};

} // namespace relievo
