// Unsaved work after a crash.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/recovery.h"
#include "core/state/state_json.h"
#include "tests/app/window_support.h"
#include <QMessageBox>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace relievo {

class RecoveryTest : public WindowTest {
protected:
    // What a process that no longer runs has left.
    QString leave(const State& lost, const char* name = "unsaved/999999999.relievo") // no process has this number
    {
        EXPECT_TRUE(QDir().mkpath(file("unsaved")));
        EXPECT_TRUE(writeState(lost, file(name).toStdString()));
        return file(name);
    }
    State lost()
    {
        State lost = state();
        lost.name = "Lost";
        lost.parameters.depth = 0.27f;
        return lost;
    }
};

TEST_F(RecoveryTest, ACopyIsKeptWhileTheDocumentIsModified)
{
    QString copy;
    {
        Recovery recovery(window.document(), file("unsaved"));
        copy = recovery.file();
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.33f; });
        ASSERT_TRUE(waitFor([&] { return QFile::exists(copy); }));
        const auto read = readState(State{}, copy.toStdString());
        ASSERT_TRUE(read);
        EXPECT_FLOAT_EQ(read->state.parameters.depth, 0.33f);
        EXPECT_FALSE(leftBehind(file("unsaved"))); // this program runs
        ASSERT_TRUE(window.document().save(file("a.relievo")));
        EXPECT_FALSE(QFile::exists(copy));
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.4f; });
        ASSERT_TRUE(waitFor([&] { return QFile::exists(copy); }));
    }
    EXPECT_FALSE(QFile::exists(copy)); // an end in good order
}

TEST_F(RecoveryTest, WhatWasLeftBehindOpensAsUnsavedWork)
{
    const QString copy = leave(lost());
    const auto found = leftBehind(file("unsaved"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->file, copy);
    restore(window, *found);
    settle();
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.27f);
    EXPECT_TRUE(window.document().isModified());
    EXPECT_TRUE(window.document().file().isEmpty());
    EXPECT_FALSE(QFile::exists(copy));
}

TEST_F(RecoveryTest, ACopyThatCannotBeOpenedStays)
{
    QFile broken(file("broken.png"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("nothing of use");
    broken.close();
    State unreadable = lost();
    unreadable.slots = {};
    unreadable.slots[std::size_t(MapKind::Height)].file = file("broken.png").toStdString();
    const QString copy = leave(unreadable);
    const State before = state();
    restore(window, *leftBehind(file("unsaved")));
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_FALSE(window.messages().all().isEmpty());
    window.assets().openDocument("sample:terrain@64", State{});
    settle();
    EXPECT_TRUE(QFile::exists(copy)) << "something else was opened";
    EXPECT_FALSE(window.document().isModified());
}

TEST_F(RecoveryTest, ACopyThatCannotBeReadStaysAndHidesNoOther)
{
    const QString copy = leave(lost());
    QFile newer(file("unsaved/999999998.relievo"));
    ASSERT_TRUE(newer.open(QIODevice::WriteOnly));
    newer.write("{\"relievo\":1000}");
    newer.close();
    const auto found = leftBehind(file("unsaved"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->file, copy);
    EXPECT_TRUE(newer.exists());
}

TEST_F(RecoveryTest, RestoredWorkIsThatOfItsProject)
{
    ASSERT_TRUE(window.document().save(file("wall.relievo")));
    QString name;
    {
        Recovery recovery(window.document(), file("unsaved"));
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.33f; });
        ASSERT_TRUE(waitFor([&] { return QFile::exists(recovery.file()); }));
        ASSERT_TRUE(QDir().mkpath(file("left")));
        name = file("left/999999999.relievo");
        ASSERT_TRUE(QFile::copy(recovery.file(), name));
        QFile::copy(recovery.file() + ".project", name + ".project");
    }
    EXPECT_TRUE(QDir(file("unsaved")).isEmpty());
    window.document().start(State{}, {});
    const auto found = leftBehind(file("left"));
    ASSERT_TRUE(found);
    restore(window, *found);
    settle();
    EXPECT_EQ(window.document().file(), file("wall.relievo"));
    EXPECT_TRUE(window.document().isModified());
    EXPECT_TRUE(QDir(file("left")).isEmpty());
    window.action("save")->trigger(); // asks for no name
    EXPECT_FALSE(window.document().isModified());
    EXPECT_FLOAT_EQ(readState(State{}, file("wall.relievo").toStdString())->state.parameters.depth, 0.33f);
}

// The names are random, so that a program with the number of one that was killed neither takes its copy for its own nor writes over it.
TEST_F(RecoveryTest, ACopyUnderThisProcessNumberIsOfferedAndKept)
{
    const QString copy = leave(lost(), ("unsaved/" + std::to_string(getpid()) + ".relievo").c_str());
    {
        Recovery recovery(window.document(), file("unsaved"));
        EXPECT_NE(recovery.file(), copy);
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.33f; });
        ASSERT_TRUE(waitFor([&] { return QFile::exists(recovery.file()); }));
        const auto found = leftBehind(file("unsaved"));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->file, copy);
        EXPECT_FALSE(leftBehind(file("unsaved"))) << "another program could be offered it meanwhile";
    }
    EXPECT_TRUE(QFile::exists(copy));
    EXPECT_TRUE(leftBehind(file("unsaved")));
}

TEST_F(RecoveryTest, ACopyIsLeftBehindWhenItsProgramIsKilled)
{
    const QString copy = leave(lost());
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    ASSERT_NE(child, -1);
    if (child == 0) { // holds the copy's lock, as a program does whose document is modified
        QLockFile lock(copy + ".lock");
        lock.setStaleLockTime(0);
        const char done = lock.tryLock(0) ? 'y' : 'n';
        (void)!write(ready[1], &done, 1);
        for (;;)
            pause();
    }
    char locked = 0;
    ASSERT_EQ(read(ready[0], &locked, 1), 1);
    EXPECT_EQ(locked, 'y');
    EXPECT_FALSE(leftBehind(file("unsaved")));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(QFile::exists(copy + ".lock"));
    EXPECT_TRUE(leftBehind(file("unsaved")));
    EXPECT_FALSE(QFile::exists(copy + ".lock")) << "given back";
    close(ready[0]);
    close(ready[1]);
}

// In a container the next program has the number of the killed one, and so has the lock that was left.
TEST_F(RecoveryTest, ALockWithThisProcessNumberIsNoSignOfLife)
{
    const QString copy = leave(lost());
    QFile stale(copy + ".lock");
    {
        QLockFile lock(copy + ".lock");
        ASSERT_TRUE(lock.tryLock(0));
        ASSERT_TRUE(stale.open(QIODevice::ReadOnly));
    }
    const QByteArray content = stale.readAll();
    stale.close();
    ASSERT_TRUE(stale.open(QIODevice::WriteOnly));
    stale.write(content);
    stale.close();
    EXPECT_TRUE(leftBehind(file("unsaved")));
}

TEST_F(RecoveryTest, EscapeKeepsWhatWasLeftBehind)
{
    const QString copy = leave(lost());
    offerLeftBehind(window, file("unsaved"));
    auto* question = window.findChild<QMessageBox*>("left-behind");
    ASSERT_NE(question, nullptr);
    ASSERT_TRUE(question->isVisible());
    const State before = state();
    QTest::keyClick(question, Qt::Key_Escape);
    EXPECT_FALSE(question->isVisible());
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(QFile::exists(copy));
}

} // namespace relievo
