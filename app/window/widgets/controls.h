// Small controls drawn for the editor: slider, segmented choice, switch, colour swatch, collapsible section, hairline.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/widgets/slider_scale.h"
#include <QAbstractButton>
#include <QColor>
#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QStringList>
#include <QVector>
#include <QWidget>

class QVBoxLayout;

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
    QSize sizeHint() const override { return {96, 20}; }
    QSize minimumSizeHint() const override { return {48, 20}; }

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

// One of a few: buttons side by side that share a frame.
class Segmented : public QWidget {
    Q_OBJECT
public:
    struct Item {
        QString text, tip;
        QIcon icon; // instead of text, when there is one
    };
    explicit Segmented(const QVector<Item>& items, QWidget* parent = nullptr);
    int current() const { return m_current; }
    void setCurrent(int index); // without signal; -1 for none
    int count() const { return int(m_items.size()); }
    QRect segment(int index) const; // px
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void chosen(int index);

protected:
    bool event(QEvent*) override; // tooltips
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    int at(QPoint point) const;
    int width(int index) const;
    QVector<Item> m_items;
    int m_current = -1, m_hovered = -1;
};

// A list to choose from. The wheel scrolls what it stands in and changes nothing; once it is open, the wheel is its popup's.
class ChoiceList : public QComboBox {
    Q_OBJECT
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

class Switch : public QAbstractButton {
    Q_OBJECT
public:
    explicit Switch(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {32, 20}; }

protected:
    void paintEvent(QPaintEvent*) override;
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
};

class Swatch : public QAbstractButton {
    Q_OBJECT
public:
    explicit Swatch(QWidget* parent = nullptr);
    void setColor(const QColor& color);
    QSize sizeHint() const override { return {64, 20}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QColor m_color;
};

// A heading that opens and closes what stands under it; remembers it under its title between sessions.
class Section : public QWidget {
    Q_OBJECT
public:
    explicit Section(const QString& title, QWidget* parent = nullptr);
    QVBoxLayout* body() const { return m_body; }
    QWidget* header() const;
    bool isOpen() const { return m_open; }
    void setOpen(bool open);

private:
    QString m_title;
    QAbstractButton* m_header;
    QWidget* m_content;
    QVBoxLayout* m_body;
    bool m_open = true;
};

// One line of text that is cut with an ellipsis where there is no room for it; then its tooltip is the whole text.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    void setFullText(const QString& text);
    const QString& fullText() const { return m_full; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void elide();
    QString m_full;
};

QFrame* hairline(QWidget* parent = nullptr); // horizontal
QFrame* upright(QWidget* parent = nullptr); // vertical

} // namespace relievo
