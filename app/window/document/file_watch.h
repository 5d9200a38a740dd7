// Notices files that other programs change, replace, remove or put back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/file_stamps.h"
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>

namespace relievo {

// Lives in the interface's thread and never reads a file. The system tells of changes in most folders, so that nothing is done while
// nothing changes; only where it does not (network folders) sizes and times are compared every two seconds.
// A file counts as changed when it has been the same for a moment: one that is being written is waited for, and so is one that was
// removed, as many programs save by removing and renaming.
class FileWatch : public QObject {
    Q_OBJECT
public:
    // Whether the system tells of changes in a folder that is there.
    using Tells = std::function<bool(const QString& folder)>;
    static bool tellsOfChanges(const QString& folder);
    explicit FileWatch(Tells tells = tellsOfChanges, QObject* parent = nullptr);

    // From now on these, as they were when they were read: one that has changed since is noticed too.
    void watch(const FileStamps& files);
    void look(); // at all of them, for the first time now

Q_SIGNALS:
    void changed(const relievo::FileNames& files); // each once for each time that it comes to rest

private:
    struct Watched {
        FileStamp known; // as it was read, or told of
        FileStamp seen; // when it was looked at last
        std::chrono::steady_clock::time_point since; // when it began to be as seen
    };
    bool comesToRest(const std::string& name, Watched& file);
    void listen();
    Tells m_tells;
    bool m_silent = false; // the system does not tell of some of the files
    std::map<std::string, Watched> m_files;
    QFileSystemWatcher m_watcher;
    QTimer m_again; // while something changes
    QTimer m_poll; // runs only where the system does not tell
};

} // namespace relievo
