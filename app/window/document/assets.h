// The large data behind the document (maps, mesh, environment), loaded in the background and kept in step with it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/background.h"
#include "app/window/document/document.h"
#include "app/window/document/file_watch.h"
#include "app/window/document/load_queue.h"
#include "app/window/document/load_results.h"
#include "app/window/document/messages.h"
#include "app/window/document/resource_store.h"
#include <QObject>
#include <functional>
#include <utility>

namespace relievo {

// An opening of which not all is there yet. It is drawn in place of the document, which it is no part of.
struct EarlyPicture {
    Job job;
    Loaded part;
};

// Everything here returns at once. What needs files waits its turn (LoadQueue) and is then shown (ResourceStore).
// What was edited while files were read stays. A failure leaves document and data as they were and stands in the messages under "load".
// Files of a document that have moved do not keep it from being shown: defaults stand in for them until they are back. Those that other
// programs change while they are shown are read again, which is no change of the document.
class Assets : public QObject {
    Q_OBJECT
public:
    Assets(Document& document, Messages& messages, QObject* parent = nullptr);

    const Resources& resources() const { return m_store.resources(); }
    bool ready() const { return m_store.ready(); }
    // What is drawn: the document, or an opening of which not all is there yet. Its mesh is null while nothing is there.
    const Resources& drawnResources() const { return m_early ? m_early->part.shown.resources : resources(); }
    bool drawsEarly() const { return m_early.has_value(); }
    State drawnState() const { return m_early ? broughtBy(m_early->job, m_early->part, m_document.state()) : m_document.state(); }
    // What the document names and is not there.
    const std::optional<StandIn>& missingMesh() const { return m_store.shown().mesh; }
    bool locatesMesh(const QString& file) const { return m_store.locatesMesh(m_document.state(), file); }
    const std::optional<StandIn>& missingEnvironment() const { return m_store.shown().environment; }
    Background& background() { return m_background; }
    Messages& messages() const { return m_messages; }

    // Whether the files that the document names are those that are loaded (acceleration maps and what has moved may be missing).
    bool upToDate() const { return m_store.isLoaded(m_document.state()); }
    void lookAgain() { m_watch.look(); } // files may have been changed or put back
    void readAgain() { filesChanged(namesOf(m_store.shown().files)); } // all files, changed or not

    // Opens a SOURCE (resources/help/command-line.md, "Sources") as a new document: a project replaces all; others take the file's values
    // and else defaults, and keep camera, light and technique.
    void openDocument(const QString& source);
    void openDocument(const QString& source, const State& base) // replaces all
    {
        request(OpenDocument{.source = source, .before = m_document.state(), .base = base});
    }
    // file: the project that it belongs to, "" for untitled.
    void openState(const State& state, const Warnings& warnings, const QString& file = {})
    {
        request(OpenState{.state = state, .before = m_document.state(), .warnings = warnings, .file = file});
    }
    // Into the present document, as one undo step, when that holds work; else as openDocument. onlyMaterial: the present mesh stays.
    void openInto(const QString& source, bool onlyMaterial = false);

    // An edit that needs other files: they are loaded first, and the document changes only when all that is new could be read.
    void propose(const QString& text, StateChange change) { request(EditNeeds{.text = text, .change = std::move(change)}); }
    // The map of one slot, as its name and pixels suggest (slotByHand); "" clears it.
    void assign(const QString& text, MapKind kind, const std::string& file) { request(assignment(text, kind, file)); }

    // Edits that wait for their files and will come to the present document: work that is not saved yet.
    bool changesPending() const { return m_queue.changesPending(); }
    void dropChanges(); // those

    // Asks before work is lost that was done while a project was loading (Files::guard); without it that work goes.
    std::function<void(std::function<void()>)> askFirst;

Q_SIGNALS:
    void resourcesChanged();
    void earlyChanged(); // what is drawn is another while the document stays
    void refused(); // the document stays as it is: what shows something else is to look again
    void changesEnded(bool all); // none is pending any more; all: none of them was refused, cancelled or dropped

private:
    void request(Job job);
    void runNext();
    void start(const QueuedJob& job, const QString& what);
    void drawEarly(std::optional<EarlyPicture> picture);
    void end(JobId id, const std::optional<Error>& why); // nothing: it is done
    void tellRefused(const Job& job, const Error& why);
    void cancelled(); // by the user
    void endChanges();
    void finish(const Job& job, const Loaded& loaded);
    void show(const Shown& shown);
    void documentChanged(Changes what);
    void filesChanged(const FileNames& files);
    void choseAgain();
    void follow();
    void stopped();
    Document& m_document;
    Messages& m_messages;
    ResourceStore m_store;
    LoadQueue m_queue;
    std::optional<EarlyPicture> m_early; // of the job that runs
    Background m_background; // works for the job that runs
    FileWatch m_watch; // over the files that are shown
};

} // namespace relievo
