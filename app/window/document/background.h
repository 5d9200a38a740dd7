// Work off the interface's thread: one piece at a time, with progress and cancel; what follows runs in the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include <QObject>
#include <functional>
#include <list>
#include <thread>

namespace relievo {

class Background : public QObject {
    Q_OBJECT
public:
    explicit Background(QObject* parent = nullptr);
    ~Background() override; // stops what runs and waits for it

    // `work` runs in a thread of its own and returns what is to be done in the interface's thread afterwards; that is dropped
    // when the work was cancelled or other work was started since. Work that still runs is asked to stop first.
    using Then = std::function<void()>;
    // what: as it is told beside the progress.
    void start(std::function<Then(const Progress&)> work, const QString& what = tr("Loading"));
    const QString& what() const { return m_what; }
    void cancel(); // no progress and no end will be heard of it
    bool busy() const { return m_current != 0; }

Q_SIGNALS:
    void busyChanged(bool busy);
    void failed(const QString& what); // the work threw: out of memory, or a fault of ours
    void progressed(float share); // [0, 1], about 20 times a second at most

private:
    Then guarded(const std::function<Then()>& work); // no exception leaves a thread
    void finish(int id, const Then& then);
    void report(int id, float share);
    struct Run {
        int id;
        std::jthread thread;
    };
    std::list<Run> m_runs; // the current one last, before it those that have yet to stop
    int m_current = 0, m_lastId = 0;
    QString m_what;
};

} // namespace relievo
