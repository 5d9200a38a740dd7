// A contact sheet or a report of the document, or a relief object of its mesh, made by the program `relievo` that lies beside the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/action.h"
#include <QObject>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <QTimer>
#include <memory>

namespace relievo {

class MainWindow;

// One at a time; told in the message line, where it can be stopped. What is written is opened by the system's program for it; an object is
// offered to be opened here.
class MeasuringRun : public QObject {
    Q_OBJECT
public:
    explicit MeasuringRun(MainWindow& window); // which owns it
    void ask(Action kind); // ContactSheet or Report: where to, then starts
    // The active pane as it is now, saved or not. out: .png; of a report .html, .csv or .json; of an object a folder. more: further options
    // of the command.
    void start(Action kind, const QString& out, const QStringList& more = {});
    void stop();
    bool busy() const { return m_process != nullptr; }

Q_SIGNALS:
    void ended(bool written);

private:
    void tellProgress(int percent);
    void read();
    void end(bool written, const QString& why);
    MainWindow& m_window;
    std::unique_ptr<QTemporaryDir> m_folder; // of the State that is measured
    QProcess* m_process = nullptr;
    Action m_kind = Action::ContactSheet; // or Report, or Impostor
    QString m_out, m_said; // the program's error stream without its progress
    QTimer m_toldLongEnough;
};

MeasuringRun& measuringOf(MainWindow& window); // made the first time

} // namespace relievo
