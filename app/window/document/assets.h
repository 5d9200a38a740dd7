// The large data behind the document (maps, mesh, environment), loaded in the background and kept in step with it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/background.h"
#include "app/window/document/document.h"
#include "app/window/document/messages.h"
#include "app/window/document/stand_ins.h"
#include <QObject>
#include <functional>
#include <list>
#include <optional>
#include <tuple>
#include <vector>

namespace relievo {

// Everything here returns at once. What needs files waits its turn: one piece of work never drops another, unless it makes it pointless.
// What was edited while files were read stays. A failure leaves document and data as they were and stands in the messages under "load".
// Files of a document that have moved do not keep it from being shown: defaults stand in for them until they are back.
class Assets : public QObject {
    Q_OBJECT
public:
    Assets(Document& document, Messages& messages, QObject* parent = nullptr);

    // Never half a set: all members, or (before the first load) none.
    const Resources& resources() const { return m_shown.resources; }
    bool ready() const { return resources().material && resources().mesh && resources().environment; }
    // What the document names and is not there.
    const std::optional<StandIn>& missingMesh() const { return m_shown.mesh; }
    bool locatesMesh(const QString& file) const; // it is missing, and `file` has its name
    const std::optional<StandIn>& missingEnvironment() const { return m_shown.environment; }
    Background& background() { return m_background; }
    Messages& messages() const { return m_messages; }

    // Whether the files that the document names are those that are loaded (bound maps and what has moved may be missing).
    bool upToDate() const { return holds(m_document.state()); }
    void lookAgain() { check(); } // files may have been put back

    // Opens a SOURCE of cli.md as a new document. Maps keep the present mesh, camera and parameters; a project replaces all.
    void openDocument(const QString& source);
    void openDocument(const QString& source, const State& base, bool counted = true); // replaces all; counted: among the recent files
    // file: the project that it belongs to, "" for untitled.
    void openState(const State& state, const Warnings& warnings, const QString& file = {});
    // Takes maps into the present document, as one undo step, when that holds work; else as openDocument.
    void openInto(const QString& source);

    // An edit that needs other files: they are loaded first, and the document changes only when all that is new could be read.
    void propose(const QString& text, std::function<void(State&)> change) { propose(text, std::move(change), {}); }
    // The map of one slot, as its name and pixels suggest (slotByHand); "" clears it.
    void assign(const QString& text, MapKind kind, const std::string& file);

    // Edits that wait for their files and will come to the present document: work that is not saved yet.
    bool changesPending() const { return !m_jobs.empty() && m_jobs.front().isStep; }
    void dropChanges(); // those

    // Asks before work is lost that was done while a project was loading (Files::guard); without it that work goes.
    std::function<void(std::function<void()>)> askFirst;

Q_SIGNALS:
    void resourcesChanged();
    void refused(); // the document stays as it is: what shows something else is to look again
    void changesEnded(bool all); // none is pending any more; all: none of them was refused, cancelled or dropped

private:
    struct Loaded;
    struct Opening {
        QString source;
        State before; // the document when it was asked for
        std::optional<State> base; // of a new document; else the maps come into the present one
        bool counted = true, asStep = false;
        std::optional<Error> instead = {}; // of what could not be opened; stays told
        QString file = {}; // of a State that is no project's own
    };
    struct Job {
        // In a thread of its own, from document and data as they are when its turn comes.
        std::function<Background::Then(const State& now, const Shown& previous, const Progress& progress)> work;
        bool whole = false; // opens a document in place of the present one
        bool isStep = false; // ends as an edit of the present one
        QString text = {}; // of a proposal
        std::function<void(State&)> change = {};
        bool looks = false; // at files, whatever is loaded
    };
    // In a thread of its own: what a proposal comes to when its file has been looked at.
    using Look = std::function<std::function<void(State&)>(DecodedImages&, Warnings&)>;
    void propose(const QString& text, std::function<void(State&)> change, const Look& look);
    // What has to be loaded or baked for a State.
    struct Needs {
        MapSlots slots;
        std::string mesh, environment;
        std::vector<std::tuple<std::string, Wrap, bool>> bounds; // of the panes
        bool operator==(const Needs&) const = default;
    };
    static Needs needsOf(const State& state);
    static Loaded open(const std::string& source, const State& base, const Shown& previous, const Progress& progress);
    void enqueue(Job job, const std::function<bool(const Job&)>& pointless); // drops earlier jobs that it makes pointless
    void enqueue(const Opening& opening, const std::function<bool(const Job&)>& pointless);
    void runNext();
    void jobEnded();
    void opened(const Opening& opening, const Loaded& loaded);
    void show(const Opening& opening, const Loaded& loaded, bool edited);
    void endChanges();
    void take(const Shown& shown);
    void follow(Changes what);
    void check();
    void tellStopped();
    QString boundMissing() const; // a map that a technique of the document searches with and that is not there
    void refuse(const Error& error);
    bool holds(const State& state) const;
    bool fits(const State& state) const;
    Document& m_document;
    Messages& m_messages;
    Shown m_shown;
    Background m_background;
    std::list<Job> m_jobs; // the first one runs; none while the data only follows the document
    bool m_refused = false; // a pending change was
    bool m_following = false; // it is being made to
    std::optional<Needs> m_followed; // what the data was last made to follow, running, cancelled or failed
};

} // namespace relievo
