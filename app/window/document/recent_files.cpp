// Recent files in the user's settings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/recent_files.h"
#include <QSettings>

namespace relievo {
namespace {
constexpr auto kKey = "recentFiles";
void store(const QStringList& list)
{
    QSettings().setValue(kKey, list);
}
} // namespace

QStringList recentFiles()
{
    return QSettings().value(kKey).toStringList();
}

void addRecentFile(const QString& source)
{
    QStringList list = recentFiles();
    list.removeAll(source);
    list.prepend(source);
    store(list.mid(0, kRecentFiles));
}

void removeRecentFile(const QString& source)
{
    QStringList list = recentFiles();
    if (list.removeAll(source) > 0)
        store(list);
}

} // namespace relievo
