// Unsaved work after a crash.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recovery.h"
#include "core/state/state_json.h"
#include "tests/app/window_support.h"

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

} // namespace relievo
