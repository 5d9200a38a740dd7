// What the actions of the table do.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/action.h"
#include <QString>

namespace relievo {

class MainWindow;

// on: of an action that toggles, what it is now.
void runAction(MainWindow& window, Action action, bool on);

// Of the active pane's camera, degrees.
void setFieldOfView(MainWindow& window, float fieldOfView);
QString fieldOfViewText(float fieldOfView); // with the lens that photographers know

} // namespace relievo
