// A field for one number: right-aligned, typed (with its unit or without), stepped by the arrow keys. What is no number is put back
// and what is out of range is limited, and either way a tooltip tells the range.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <QLineEdit>
#include <optional>

namespace relievo {

class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(const ParameterRow& row, QWidget* parent = nullptr);
    void setValue(double value); // without signals
    void commit(); // takes what is typed, as Enter does

Q_SIGNALS:
    void entered(double value); // typed and done, within the row's limits
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
    void sayRange();
    const ParameterRow& m_row;
    double m_value = 0;
    bool m_stepping = false; // an arrow key is down
};

// "45", "45 deg", "45\u00b0", "5 %" of what is a share, "auto"; nothing when it is none.
std::optional<double> typedNumber(const ParameterRow& row, QString text);

// Before the document is saved, exported or closed: takes the number that is being typed in `window`.
void commitTyping(const QWidget* window);

} // namespace relievo
