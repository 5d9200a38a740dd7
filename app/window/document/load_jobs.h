// The kinds of work that wait for files, and what each comes to in a thread of its own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/resource_store.h"
#include "core/scene/source.h"
#include <functional>
#include <optional>
#include <variant>

namespace relievo {

using StateChange = std::function<void(State&)>;

// A SOURCE (resources/help/command-line.md, "Sources") takes the place of the present document.
struct OpenDocument {
    QString source;
    State before; // the document when this was asked for: what was edited since would be lost
    std::optional<State> base = {}; // read on this; else on the document as it is when the turn comes
    bool counted = true; // among the recent files
    std::optional<Error> insteadOf = {}; // opened because of this failure, which stays told
};

// A State that has been read already takes the place of the present document.
struct OpenState {
    State state;
    State before; // as above
    Warnings warnings = {};
    QString file = {}; // the project that it belongs to, "" for untitled
};

// A SOURCE that is no project: its values count, else defaults; of the document before stay camera, light and technique.
struct OpenInto {
    QString source;
    State before; // as above; then it comes as an undo step in any case
    bool asStep = false; // of undo, on the present mesh unless it brings one; else it begins a document of its own
    bool onlyMaterial = false; // of a mesh file: the present mesh stays
};

// An edit that needs other files: the document changes only when all that is new could be read.
struct EditNeeds {
    // Looks at the file itself, in the job's thread, and settles what the change is.
    using Look = std::function<StateChange(DecodedImages&, Warnings&)>;
    QString text; // of the undo step
    StateChange change; // as it is known without looking
    Look look = {};
};

// The data follows the document: other files after an undo, another acceleration map for another technique.
struct Follow {
    Needs needs;
};

using Job = std::variant<OpenDocument, OpenState, OpenInto, EditNeeds, Follow>;

bool replacesDocument(const Job& job);
bool isOpening(const Job& job); // of a document, or into this one
bool isChange(const Job& job); // ends as an undo step of the present document

// The map of one slot, as its name and pixels suggest (slotByHand); "" clears it.
EditNeeds assignment(const QString& text, MapKind kind, const std::string& file);

// Whether a SOURCE is a document of its own, not maps for the present one.
bool isWholeDocument(const QString& source);

// What is opened where nothing is shown yet, for the window is never empty; insteadOf: of what could not be opened.
OpenDocument firstDocument(const State& now, const std::optional<Error>& insteadOf = {});
bool standsInForAnother(const Job& job);

// What was read for a job.
struct Loaded {
    State base; // it was read on this
    Opened opened; // the State that the files are of; its pictures are used up
    Shown shown;
    StateChange change = {}; // of an edit, settled
};

// Hears of a texture set that is opened while it is being read (EarlySet): with stand-ins for the maps that are coming, and fit to be
// drawn.
using EarlyLoaded = std::function<void(const Loaded&)>;

// From document and data as they are when the job's turn comes; any thread. An edit whose new files could not be read is an error.
Expected<Loaded> load(const Job& job, const State& now, const Shown& previous, const Progress& progress, const EarlyLoaded& early = {});

} // namespace relievo
