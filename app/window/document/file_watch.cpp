// Watching files and the folders that they lie in.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/file_watch.h"
#include "core/gltf/pictures.h"
#include <QStorageInfo>
#include <QStringList>
#include <algorithm>
#include <utility>

namespace relievo {
namespace fs = std::filesystem;
using namespace std::chrono_literals;
namespace {
constexpr auto kLook = 60ms; // after the system told of something, and again while something changes
constexpr auto kRest = 200ms; // as long a file has to stay the same
constexpr auto kGone = 400ms; // and stay away
constexpr auto kPoll = 2s;

// The folder that `file` lies in, or what is there of the way to it.
fs::path folderOf(const fs::path& file)
{
    std::error_code code;
    fs::path folder = file.parent_path();
    while (folder.has_relative_path() && !fs::is_directory(folder, code))
        folder = folder.parent_path();
    return folder;
}

QString nameOf(const fs::path& path)
{
    return QString::fromStdString(path.string());
}
} // namespace

bool FileWatch::tellsOfChanges(const QString& folder)
{
    static constexpr const char* kSilent[] = {"nfs", "cifs", "smb", "fuse", "9p", "afs", "ncp", "vboxsf", "prl_fs", "vmhgfs", "drvfs",
        "ceph", "gluster", "lustre"}; // beginnings of the names of file systems that others write to from elsewhere
    const QByteArray type = QStorageInfo(folder).fileSystemType().toLower();
    return std::ranges::none_of(kSilent, [&](const char* silent) { return type.startsWith(silent); });
}

FileWatch::FileWatch(Tells tells, QObject* parent) : QObject(parent), m_tells(std::move(tells))
{
    m_again.setSingleShot(true);
    m_again.setInterval(kLook);
    m_poll.setInterval(kPoll);
    const auto soon = [this] {
        if (!m_again.isActive())
            m_again.start();
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, soon);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, soon);
    connect(&m_again, &QTimer::timeout, this, &FileWatch::look);
    connect(&m_poll, &QTimer::timeout, this, &FileWatch::look);
}

void FileWatch::watch(const FileStamps& files)
{
    m_files.clear();
    FileNames folders;
    for (const auto& [name, stamp] : files) {
        m_files[name] = {.known = stamp, .seen = stamp, .since = {}};
        folders.insert(folderOf(fileOfPicture(name)).string());
    }
    m_silent = !std::ranges::all_of(folders, [this](const std::string& folder) { return m_tells(QString::fromStdString(folder)); });
    look();
}

void FileWatch::look()
{
    FileNames atRest;
    bool changes = false;
    for (auto& [name, file] : m_files) {
        if (comesToRest(name, file))
            atRest.insert(name);
        changes = changes || file.seen != file.known;
    }
    listen();
    if (changes)
        m_again.start();
    if (!atRest.empty())
        Q_EMIT changed(atRest);
}

bool FileWatch::comesToRest(const std::string& name, Watched& file)
{
    const FileStamp now = stampOf(name);
    const auto time = std::chrono::steady_clock::now();
    if (now != file.seen) {
        file.seen = now, file.since = time;
        m_watcher.removePath(nameOf(fileOfPicture(name))); // another file may have its name now
    }
    if (file.seen == file.known || time - file.since < (now.isThere ? kRest : kGone))
        return false;
    file.known = file.seen;
    return true;
}

// A file that was replaced or removed is no longer watched, one that has come is not yet.
void FileWatch::listen()
{
    QStringList wanted;
    for (const auto& [name, file] : m_files) {
        const fs::path path = fileOfPicture(name);
        const fs::path folder = folderOf(path);
        wanted << nameOf(folder) << nameOf(folder.parent_path()); // which tells when the folder is renamed
        if (file.seen.isThere)
            wanted.append(nameOf(path));
    }
    wanted.removeDuplicates();
    bool silent = m_silent;
    const QStringList had = m_watcher.files() + m_watcher.directories();
    QStringList less, more;
    std::ranges::copy_if(had, std::back_inserter(less), [&](const QString& path) { return !wanted.contains(path); });
    std::ranges::copy_if(wanted, std::back_inserter(more), [&](const QString& path) { return !had.contains(path); });
    if (!less.isEmpty())
        m_watcher.removePaths(less);
    if (!more.isEmpty() && !m_watcher.addPaths(more).isEmpty())
        silent = true; // the system cannot watch so many, or not those
    if (silent != m_poll.isActive())
        silent ? m_poll.start() : m_poll.stop();
}

} // namespace relievo
