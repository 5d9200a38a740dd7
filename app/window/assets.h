// The large data behind the document (maps, mesh, environment), loaded in the background and kept in step with it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/background.h"
#include "app/window/document.h"
#include "app/window/messages.h"
#include "core/source.h"
#include <QObject>
#include <functional>
#include <list>
#include <optional>
#include <tuple>
#include <vector>

namespace relievo {

// Everything here returns at once. What needs files waits its turn: one piece of work never drops another, unless it makes it pointless.
// What was edited while files were read stays. A failure leaves document and data as they were and stands in the messages under "load".
class Assets : public QObject {
    Q_OBJECT
public:
    Assets(Document& document, Messages& messages, QObject* parent = nullptr);

    // Never half a set: all members, or (before the first load) none.
    const Resources& resources() const { return m_resources; }
    bool ready() const { return m_resources.material && m_resources.mesh && m_resources.environment; }
    Background& background() { return m_background; }

    // Whether the files that the document names are those that are loaded (bound maps may be missing).
    bool upToDate() const { return holds(m_document.state()); }

    // Opens a SOURCE of cli.md as a new document. Maps keep the present mesh, camera and parameters; a project replaces all.
    void openDocument(const QString& source);
    void openDocument(const QString& source, const State& base, bool counted = true); // replaces all; counted: among the recent files
    void openState(const State& state, const Warnings& warnings); // untitled
    // Takes maps into the present document, as one undo step, when that holds work; else as openDocument.
    void openInto(const QString& source);

    // An edit that needs other files: they are loaded first, and the document changes only when all that is new could be read.
    void propose(const QString& text, std::function<void(State&)> change);

    // Asks before work is lost that was done while a project was loading (Files::guard); without it that work goes.
    std::function<void(std::function<void()>)> askFirst;

Q_SIGNALS:
    void resourcesChanged();
    void refused(); // the document stays as it is: what shows something else is to look again

private:
    struct Loaded;
    struct Opening {
        QString source;
        State before; // the document when it was asked for
        std::optional<State> base; // of a new document; else the maps come into the present one
        bool counted = true, asStep = false;
        std::optional<Error> instead = {}; // of what could not be opened; stays told
    };
    struct Job {
        // In a thread of its own, from document and data as they are when its turn comes.
        std::function<Background::Then(const State& now, const Resources& previous, const Progress& progress)> work;
        bool whole = false; // opens a document in place of the present one
        QString text = {}; // of a proposal
        std::function<void(State&)> change = {};
    };
    // What has to be loaded or baked for a State.
    struct Needs {
        MapSlots slots;
        std::string mesh, environment;
        std::vector<std::tuple<std::string, Wrap, bool>> bounds; // of the panes
        bool operator==(const Needs&) const = default;
    };
    static Needs needsOf(const State& state);
    static Loaded open(const std::string& source, const State& base, const Resources& previous, const Progress& progress);
    void enqueue(Job job, const std::function<bool(const Job&)>& pointless); // drops earlier jobs that it makes pointless
    void enqueue(const Opening& opening, const std::function<bool(const Job&)>& pointless);
    void runNext();
    void jobEnded();
    void opened(const Opening& opening, const Loaded& loaded);
    void show(const Opening& opening, const Loaded& loaded, bool edited);
    void take(const Resources& resources);
    void follow(Changes what);
    void check();
    void refuse(const Error& error);
    bool holds(const State& state) const;
    bool fits(const State& state) const;
    Document& m_document;
    Messages& m_messages;
    Resources m_resources;
    Background m_background;
    std::list<Job> m_jobs; // the first one runs; none while the data only follows the document
    std::optional<Needs> m_followed; // what the data was last made to follow, running, cancelled or failed
};

} // namespace relievo
