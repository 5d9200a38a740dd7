// Unsaved work outlives a crash: it is written to a folder of the user's some seconds after a change, and offered at the next start.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/main_window.h"
#include "core/state/state_json.h"
#include <QTimer>
#include <optional>

namespace relievo {

// ... in the user's own data folder.
QString recoveryFolder();

// Keeps a copy of the document while it is modified, in a file named after this process, and beside it the name of its project file; an
// end in good order removes both.
class Recovery : public QObject {
public:
    explicit Recovery(Document& document, const QString& folder = recoveryFolder());
    ~Recovery() override;
    QString file() const { return m_file; }

private:
    void documentChanged();
    void write();
    Document& m_document;
    QString m_file;
    QTimer m_wait;
};

// The newest copy whose program runs no more and that can be read; others (of a newer version) stay where they are.
struct LeftBehind {
    QString file;
    StateRead read;
    QString project; // that it is the unsaved work of; "" for untitled
};
std::optional<LeftBehind> leftBehind(const QString& folder = recoveryFolder());

// Opens a copy as unsaved work of its project and removes it; one that cannot be opened stays.
void restore(MainWindow& window, const LeftBehind& copy);

// Asks whether what was left behind shall be opened or discarded; closing the question, or Escape, keeps it for the next start.
void offerLeftBehind(MainWindow& window, const QString& folder = recoveryFolder());

} // namespace relievo
