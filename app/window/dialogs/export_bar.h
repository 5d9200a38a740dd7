// The lower edge of the export dialog: its buttons, progress, and which picture is exported.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace relievo {

class ExportBar : public QWidget {
    Q_OBJECT
public:
    explicit ExportBar(QWidget* parent = nullptr);
    void showWhich(const State& state); // of several pictures
    void setBusy(bool busy);
    void setProgress(float share); // [0, 1]
    void offerFolder(bool on); // of what was written

Q_SIGNALS:
    void exportWanted();
    void stopWanted();
    void folderWanted();
    void closeWanted();

private:
    QPushButton* button(const QString& text, const char* name, void (ExportBar::*wanted)());
    QLabel* m_which;
    QProgressBar* m_progress;
    QPushButton *m_openFolder, *m_cancel, *m_close, *m_export;
};

} // namespace relievo
