// What the actions of the table do.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/action.h"

namespace relievo {

class MainWindow;

// on: of an action that toggles, what it is now.
void runAction(MainWindow& window, Action action, bool on);

} // namespace relievo
