// A field for one number: right-aligned, typed, stepped by the arrow keys, put back when what is typed is no number.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <QLineEdit>

namespace relievo {

class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(const ParameterRow& row, QWidget* parent = nullptr);
    void setValue(double value); // without signals
    void commit(); // takes what is typed, as Enter does

Q_SIGNALS:
    void entered(double value); // typed and done, within the row's limits
    void outOfRange(); // typed beyond the limits; the nearest allowed value was entered
    void pressed(); // an arrow key goes down: what is entered up to `released` is one gesture
    void released();

protected:
    bool event(QEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;

private:
    void endStepping();
    const ParameterRow& m_row;
    double m_value = 0;
    bool m_stepping = false; // an arrow key is down
};

// Before the document is saved, exported or closed: takes the number that is being typed in `window`.
void commitTyping(const QWidget* window);

} // namespace relievo
