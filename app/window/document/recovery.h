// Unsaved work outlives a crash: it is written to a folder of the user's some seconds after a change, and offered at the next start.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/main_window.h"
#include "core/state/state_json.h"
#include <QLockFile>
#include <QTimer>
#include <memory>
#include <optional>

namespace relievo {

// ... in the user's own data folder.
QString recoveryFolder();

// Keeps a copy of the document while it is modified, in a file with a random name, and beside it the name of its project file and a lock,
// which the system gives back when this program ends, however it does. An end in good order removes all three; no other copy is touched.
class Recovery : public QObject {
public:
    explicit Recovery(Document& document, const QString& folder = recoveryFolder());
    ~Recovery() override;
    QString file() const { return m_file; }

private:
    void documentChanged();
    void write();
    void forget();
    Document& m_document;
    QString m_file;
    QLockFile m_lock; // while there is a copy
    QTimer m_wait;
};

// The newest copy whose program runs no more and that can be read; others (of a newer version) stay where they are. While this value lives
// no other program finds the copy.
struct LeftBehind {
    QString file;
    StateRead read;
    QString project; // that it is the unsaved work of; "" for untitled
    std::shared_ptr<QLockFile> lock;
};
std::optional<LeftBehind> leftBehind(const QString& folder = recoveryFolder());

// Opens a copy as unsaved work of its project and removes it; one that cannot be opened stays.
void restore(MainWindow& window, const LeftBehind& copy);

// Asks whether what was left behind shall be opened or discarded; closing the question, or Escape, keeps it for the next start.
void offerLeftBehind(MainWindow& window, const QString& folder = recoveryFolder());

} // namespace relievo
