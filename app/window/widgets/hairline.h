// Lines between things.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QFrame>

namespace relievo {

QFrame* hairline(QWidget* parent = nullptr); // horizontal
QFrame* upright(QWidget* parent = nullptr); // vertical

} // namespace relievo
