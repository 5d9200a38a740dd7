// What lies over the picture: captions, the legend of heat maps and hints. None takes the mouse from the picture but the captions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include "render/renderer.h"
#include <QAbstractButton>
#include <QString>
#include <QWidget>
#include <optional>

namespace relievo {

// "relief 8-32+6": the technique and what decides its cost, for the caption of a pane.
QString techniqueText(const State& state, std::size_t pane);

QString paneLetter(std::size_t pane); // "A" for the first

// A word with an arrow in a caption; pressed, it offers others; pulled, it can be dropped on another pane.
class CaptionChoice : public QAbstractButton {
    Q_OBJECT
public:
    CaptionChoice(const char* name, const QString& tip, QWidget* parent);
    QSize sizeHint() const override;

Q_SIGNALS:
    void pulled();

protected:
    void paintEvent(QPaintEvent*) override;
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;

private:
    QPoint m_pressedAt;
};

// A chip in a pane's corner: letter (of several panes), technique and view, each of which offers the others, measured cost, and of several
// panes what can be done with it.
class PaneCaption : public QWidget {
    Q_OBJECT
public:
    explicit PaneCaption(QWidget* parent);
    void show(const QString& letter, const QString& technique, const QString& view, const QString& cost, bool active);
    void fit(int room); // px; where it is too narrow for all, the cost goes under the rest, then goes, then technique and view are cut
    CaptionChoice* technique() const { return m_technique; }
    CaptionChoice* view() const { return m_view; }
    CaptionChoice* more() const { return m_more; } // the letter

protected:
    void paintEvent(QPaintEvent*) override;

private:
    int wide(const QString& text) const; // px
    CaptionChoice *m_more, *m_technique, *m_view;
    QString m_cost;
    QPoint m_costFrom; // beside or under them; null: there is no room for it
    bool m_active = false;
};

// The colours of a heat view with numbers and unit, and what its pixels show; under the pointer, how many show how much. A double click
// asks for a scale that ends at the 99th percentile.
class HeatLegend : public QWidget {
    Q_OBJECT
public:
    explicit HeatLegend(QWidget* parent);
    void show(const QString& title, const QString& unit, double max, const std::optional<HeatNumbers>& numbers = {});
    double max() const { return m_max; } // at the bright end
    QString caption() const; // what the numbers of the scale are
    QString summary() const; // of the pixels; "" while it is not known
    QSize sizeHint() const override;

Q_SIGNALS:
    void fitWanted(double most);

protected:
    void paintEvent(QPaintEvent*) override;
    void enterEvent(QEnterEvent*) override { unfold(true); }
    void leaveEvent(QEvent*) override { unfold(false); }
    void mouseDoubleClickEvent(QMouseEvent*) override;

private:
    void unfold(bool open);
    void paintHistogram(QPainter& painter, const QRect& room) const;
    QString m_title, m_unit;
    double m_max = 1;
    std::optional<HeatNumbers> m_numbers;
    bool m_isOpen = false;
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
