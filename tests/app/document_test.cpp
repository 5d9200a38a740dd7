// The document: one door, undo by gesture, the camera outside of it, saving and opening again.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/document.h"
#include "core/state/state_json.h"
#include <QTemporaryDir>
#include <gtest/gtest.h>

using namespace relievo;

namespace {
void setDepth(Document& document, float depth)
{
    document.edit("Depth", [&](State& state) { state.parameters.depth = depth; });
}
} // namespace

TEST(Document, EditsOfOneGestureAreOneStep)
{
    Document document;
    const State before = document.state();
    document.beginGesture();
    for (float depth : {0.1f, 0.2f, 0.3f})
        setDepth(document, depth);
    document.endGesture();
    EXPECT_EQ(document.undoStack().count(), 1);
    EXPECT_TRUE(document.isModified());
    document.undoStack().undo();
    EXPECT_EQ(document.state(), before);
    document.undoStack().redo();
    EXPECT_FLOAT_EQ(document.state().parameters.depth, 0.3f);
}

TEST(Document, EditsOutsideOfGesturesAreStepsOfTheirOwn)
{
    Document document;
    setDepth(document, 0.1f);
    setDepth(document, 0.2f);
    EXPECT_EQ(document.undoStack().count(), 2);
}

TEST(Document, TwoGesturesAreTwoSteps)
{
    Document document;
    for (float depth : {0.1f, 0.2f}) {
        document.beginGesture();
        setDepth(document, depth);
        document.endGesture();
    }
    EXPECT_EQ(document.undoStack().count(), 2);
}

TEST(Document, BackWhereItBeganLeavesNoStep)
{
    Document document;
    const float before = document.state().parameters.depth;
    document.beginGesture();
    setDepth(document, 0.3f);
    setDepth(document, before);
    document.endGesture();
    EXPECT_EQ(document.undoStack().count(), 0);
    EXPECT_FALSE(document.isModified());
}

TEST(Document, CameraMovesAreNoStepsAndSurviveUndo)
{
    Document document;
    setDepth(document, 0.2f);
    document.edit("Camera", [](State& state) { state.camera.yaw = 77.f; });
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_FLOAT_EQ(document.state().camera.yaw, 77.f);
    EXPECT_FALSE(document.isModified());
}

TEST(Document, SaysWhatChanged)
{
    Document document;
    Changes heard;
    QObject::connect(&document, &Document::changed, [&](Changes what) { heard = what; });
    document.edit("Mesh", [](State& state) { state.mesh = "torus"; });
    EXPECT_EQ(heard, Changes(Change::Mesh));
    document.edit("Camera", [](State& state) { state.camera.fov = 50.f; });
    EXPECT_EQ(heard, Changes(Change::Camera));
}

TEST(Document, AnEditThatMovesTheEyeTooIsOneChange)
{
    Document document;
    std::vector<State> seen;
    QObject::connect(&document, &Document::changed, [&](Changes) { seen.push_back(document.state()); });
    document.edit("Scene", [](State& state) { state.mesh = "torus", state.camera.yaw = 77.f; });
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].mesh, "torus");
    EXPECT_EQ(seen[0].camera.yaw, 77.f);
    document.undoStack().undo();
    EXPECT_EQ(document.state().mesh, State().mesh);
    EXPECT_EQ(document.state().camera.yaw, 77.f);
}

TEST(Document, SavedAndReadAgainIsEqual)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("wall.relievo");
    Document document;
    setDepth(document, 0.2f);
    document.edit("Panes", [](State& state) {
        state.panes.push_back({"parallax", {{"maxSteps", 64}, {"depth", 0.3f}}});
        setView(state, "normal");
    });
    ASSERT_TRUE(document.save(file));
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(document.name(), "wall");
    const auto read = readState(State{}, file.toStdString());
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->warnings.empty());
    EXPECT_EQ(read->state, document.state());
    setDepth(document, 0.1f);
    EXPECT_TRUE(document.isModified());
    document.undoStack().undo();
    EXPECT_FALSE(document.isModified());
}

TEST(Document, AFailedSaveKeepsItUnsaved)
{
    Document document;
    setDepth(document, 0.2f);
    const auto saved = document.save("/no/such/folder/x.relievo");
    ASSERT_FALSE(saved);
    EXPECT_NE(message(saved.error()).find("/no/such/folder"), std::string::npos);
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(document.file().isEmpty());
}
