// A list to choose from.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QComboBox>
#include <QWheelEvent>

namespace relievo {

// The wheel scrolls what it stands in and changes nothing; once it is open, the wheel is its popup's.
class ChoiceList : public QComboBox {
    Q_OBJECT
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); } // passed on to the parent
};

} // namespace relievo
