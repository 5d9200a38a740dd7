// Says, while a file is dragged over the window, that it can be dropped there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

namespace relievo {

// A frame around the picture with a word in it, from the moment at which a file is dragged into the window until it leaves or is dropped.
class DropFrame : public QWidget {
    Q_OBJECT
public:
    // picture: what it surrounds, a part of the window.
    DropFrame(QWidget* picture, QWidget* window);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void paintEvent(QPaintEvent*) override;

private:
    QWidget* m_picture;
};

} // namespace relievo
