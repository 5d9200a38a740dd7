// How what was loaded for a job comes to the document, and what the messages say of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "app/window/document/load_jobs.h"
#include "app/window/document/messages.h"
#include "app/window/document/resource_store.h"

namespace relievo {

// Whether more than camera and moment was edited since the document was `before`.
bool editedSince(const State& before, const Document& document);
// Work that would be lost: what was edited while a document was read that replaces the present one.
bool losesWork(const Job& job, const Document& document);

// The document that an opening comes to, when it is `now`: what was edited while it was read stays in what is no document of its own.
State broughtBy(const Job& job, const Loaded& loaded, const State& now);

// The change of the document, once its data is shown.
void applyLoaded(const Job& job, const Loaded& loaded, Document& document);

void tellLoaded(const Job& job, const Loaded& loaded, Messages& messages); // before it is shown
void tellShown(const Shown& shown, Messages& messages);
// Once it is applied: which files have been read again, the offer to keep depth and tiling of the document before where they had been
// changed since that one began, and what could not be opened.
struct Before {
    FileStamps files;
    State state, began; // of the document
};
void tellApplied(const Job& job, const Loaded& loaded, const Before& before, Document& document, Messages& messages);
// The work goes on without what was refused. resources: nullptr before the first load.
void tellEdited(const State& state, const Resources* resources, Messages& messages);
// map: the acceleration map that is all that is missing, "" when files are.
void tellFollowing(const QString& map, Messages& messages);
void tellStopped(const QString& map, Messages& messages);

} // namespace relievo
