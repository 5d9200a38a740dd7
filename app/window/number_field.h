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

Q_SIGNALS:
    void entered(double value); // typed and done, within the row's limits
    void outOfRange(); // typed beyond the limits; the nearest allowed value was entered

protected:
    void focusInEvent(QFocusEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    void commit();
    const ParameterRow& m_row;
    double m_value = 0;
};

} // namespace relievo
