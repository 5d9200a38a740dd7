// What is dropped is read where it lies.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

namespace relievo {

// The file that a drag brings: the first of several. "" when it brings none.
inline QString draggedFile(const QDropEvent& event)
{
    const QList<QUrl> urls = event.mimeData()->urls();
    return urls.isEmpty() ? QString() : urls.front().toLocalFile();
}

// Takes a drag or drop as a copy, whatever its source proposes: after a move the source would remove its file. Left alone, and refused
// by that, when neither a copy nor a link is allowed.
inline void acceptCopy(QDropEvent& event)
{
    for (const Qt::DropAction action : {Qt::CopyAction, Qt::LinkAction})
        if (event.possibleActions() & action) {
            event.setDropAction(action);
            event.accept();
            return;
        }
    event.ignore();
}

} // namespace relievo
