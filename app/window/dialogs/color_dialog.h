// The colour chooser of a parameter: what is chosen by one drag or typed in one field is one gesture, also while it stays open.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QColorDialog>

namespace relievo {

// Not modal, without buttons: colours take effect at once.
class ColorDialog : public QColorDialog {
    Q_OBJECT
public:
    ColorDialog(const QColor& color, QWidget* parent);
    void show(const QColor& color); // without a signal; not while one is being chosen

Q_SIGNALS:
    void pressed(); // a choice begins
    void chosen(const QColor& color);
    void released(); // it ends

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void choose(const QColor& color);
    void end();
    bool m_choosing = false;
};

} // namespace relievo
