// Two buttons that show a value: on or off, and a colour.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QAbstractButton>
#include <QColor>

namespace relievo {

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

} // namespace relievo
