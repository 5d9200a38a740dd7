// The sources opened last, newest first, kept between sessions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QStringList>

namespace relievo {

inline constexpr int kRecentFiles = 10;

QStringList recentFiles();
void addRecentFile(const QString& source); // moves it to the front; the oldest beyond kRecentFiles is forgotten
void removeRecentFile(const QString& source);

} // namespace relievo
