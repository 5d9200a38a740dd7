// The document: one State, one door to change it, one undo command for everything, and the project file behind it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/state.h"
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

namespace relievo {

// Which parts of the State differ from before; found by comparison.
enum class Change {
    Name = 1,
    Parameters = 2,
    Maps = 4,
    Mesh = 8,
    Environment = 16,
    Camera = 32,
    View = 64,
    Panes = 128,
    Moment = 256, // of an animation
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

Changes differences(const State& a, const State& b);

// Lives in the interface's thread.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);

    const State& state() const { return m_state; }
    QUndoStack& undoStack() { return m_undo; }

    // The only door. A change of nothing but the camera and the moment of an animation is no undo step; any other is one, and inside a
    // gesture all edits with the same text are one together, or none when they end where they began. `text` names the step in the menu.
    void edit(const QString& text, const std::function<void(State&)>& change);
    void beginGesture(); // slider or mouse pressed; a gesture may lie in another
    void endGesture(); // released
    void resumeGesture(); // the last one goes on, for the second press of a double click
    bool inGesture() const { return m_depth > 0; }

    // Another document begins: nothing to undo, nothing unsaved. `file`: the project it was read from, "" for untitled.
    void start(const State& state, const QString& file);

    // Writes the project; on an error nothing changes. Afterwards the document counts as saved under `file`.
    Expected<void> save(const QString& file);

    bool isModified() const { return !m_undo.isClean(); }
    const State& began() const { return m_began; } // as it was opened
    const QString& file() const { return m_file; }
    QString name() const; // of the file without suffix, else of the material

Q_SIGNALS:
    void changed(relievo::Changes what);
    void titleChanged(); // file, name or modified
    void started(); // another document
    void choseAgain(); // an edit asked for what is there already (not by a drag)
    void gestureEnded();

private:
    class Edit;
    void replace(const State& next);
    State m_state, m_began;
    QUndoStack m_undo;
    QString m_file;
    int m_gesture = 0, m_depth = 0;
};

} // namespace relievo
