// A choice of a few, all of them in view.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QIcon>
#include <QVector>
#include <QWidget>

namespace relievo {

// One of a few: buttons side by side that share a frame.
class Segmented : public QWidget {
    Q_OBJECT
public:
    struct Item {
        QString text, tip;
        QIcon icon; // instead of text, when there is one
    };
    explicit Segmented(const QVector<Item>& items, QWidget* parent = nullptr);
    void setItems(const QVector<Item>& items); // none of them is current then
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

} // namespace relievo
