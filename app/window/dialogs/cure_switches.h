// Switches for what is done to the maps on their way out.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include <QWidget>

namespace relievo {

class Switch;

// One a row of kCures, as the row says until it was turned: the settings keep that.
class CureSwitches : public QWidget {
    Q_OBJECT
public:
    explicit CureSwitches(QWidget* parent = nullptr);
    EnumSet<Cure> cures() const; // that are on
    void setUsed(EnumSet<Cure> used); // the others cannot be pressed

Q_SIGNALS:
    void edited();

private:
    PerChoice<Cure, Switch*> m_switches;
    PerChoice<Cure, QWidget*> m_labels;
};

} // namespace relievo
