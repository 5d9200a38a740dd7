// Unsaved work after a crash.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recovery.h"
#include "core/state/state_json.h"
#include "tests/app/window_support.h"

namespace relievo {

class RecoveryTest : public WindowTest { };

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
        EXPECT_EQ(leftBehind(file("unsaved")), QString()); // this program runs
        ASSERT_TRUE(window.document().save(file("a.relievo")));
        EXPECT_FALSE(QFile::exists(copy));
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.4f; });
        ASSERT_TRUE(waitFor([&] { return QFile::exists(copy); }));
    }
    EXPECT_FALSE(QFile::exists(copy)); // an end in good order
}

TEST_F(RecoveryTest, WhatWasLeftBehindOpensAsUnsavedWork)
{
    ASSERT_TRUE(QDir().mkpath(file("unsaved")));
    const QString copy = file("unsaved/999999999.relievo"); // no process has this number
    State lost = state();
    lost.name = "Lost";
    lost.parameters.depth = 0.27f;
    ASSERT_TRUE(writeState(lost, copy.toStdString()));
    EXPECT_EQ(leftBehind(file("unsaved")), copy);
    restore(window, copy);
    settle();
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.27f);
    EXPECT_TRUE(window.document().isModified());
    EXPECT_TRUE(window.document().file().isEmpty());
    EXPECT_FALSE(QFile::exists(copy));
}

} // namespace relievo
