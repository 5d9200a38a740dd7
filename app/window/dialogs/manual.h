// The manual in a window beside the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace relievo {

void showManual(QWidget* parent); // the one that is open comes to the front

} // namespace relievo
