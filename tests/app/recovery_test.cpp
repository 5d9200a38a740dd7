// Unsaved work after a crash.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/recovery.h"
#include "core/state/state_json.h"
#include "tests/app/window_support.h"
#include <QMessageBox>
#include <sys/prctl.h>
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

TEST_F(RecoveryTest, AProcessThatHasEndedDoesNotRun)
{
    const pid_t child = fork();
    ASSERT_NE(child, -1);
    if (child == 0) {
        prctl(PR_SET_NAME, "relievo-editor");
        for (;;)
            pause();
    }
    const auto state = [&] {
        QFile stat(QString("/proc/%1/stat").arg(child));
        return stat.open(QIODevice::ReadOnly) ? stat.readAll() : QByteArray();
    };
    const bool named = waitFor([&] { return state().contains("(relievo-editor)"); });
    const QString copy = leave(lost(), ("unsaved/" + std::to_string(child) + ".relievo").c_str());
    const bool ran = !leftBehind(file("unsaved"));
    kill(child, SIGKILL);
    const bool ended = waitFor([&] { return state().contains(") Z "); });
    const auto found = leftBehind(file("unsaved"));
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(named && ran && ended);
    EXPECT_TRUE(found) << "nobody has asked for its end, but it does not run";
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
