// The ends of the jobs, in the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/load_results.h"
#include "app/window/document/recent_files.h"
#include "core/gltf/pictures.h"
#include "core/ground/shown_text.h"
#include "core/scene/source.h"
#include <QFileInfo>
#include <cmath>

namespace relievo {
namespace {
void addToRecent(const QString& source)
{
    if (!isBuiltInSource(source.toStdString()))
        addRecentFile(QFileInfo(source).absoluteFilePath());
}

// Techniques and values of the panes; where they look and what they show stays as it is.
void bringPanes(State& state, const State& opened)
{
    state.panes.resize(opened.panes.size(), state.panes.front());
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane) {
        state.panes[pane].technique = opened.panes[pane].technique;
        state.panes[pane].overrides = opened.panes[pane].overrides;
    }
}

// What a SOURCE of maps brings into `state`; what was edited there while it was read stays.
void bringMaps(State& state, const Loaded& loaded, bool builtIn)
{
    const State &opened = loaded.opened.state, &base = loaded.base;
    state.slots = opened.slots;
    state.name = opened.name;
    if (builtIn) // a sample brings its depth
        state.parameters.depth = opened.parameters.depth;
    if (opened.mesh != base.mesh) // a mesh with textures
        state.mesh = opened.mesh, state.part = opened.part;
    if (opened.mesh != base.mesh || (loaded.opened.bringsValues && opened.panes != base.panes))
        bringPanes(state, opened);
    if (!loaded.opened.bringsValues)
        return;
    for (const ParameterRow& row : kParameters)
        if (const Value value = get(opened.parameters, row); value != get(base.parameters, row))
            set(state.parameters, row, value);
}

// A mesh that is new to the document starts with a relief that fits it, unless the file says how deep its own is.
void fitDepth(State& state, const State& base, const Loaded& loaded)
{
    if (state.mesh == base.mesh || loaded.shown.mesh || loaded.opened.bringsValues)
        return;
    const float fits = fittingDepth(state.parameters, loaded.shown.resources);
    if (!(state.parameters.depth > fits))
        return;
    const double unit = std::pow(10., std::floor(std::log10(double(fits))) - 1.); // two digits
    state.parameters.depth = float(std::floor(double(fits) / unit) * unit);
}

void apply(const OpenDocument& job, const Loaded& loaded, Document& document)
{
    const bool isProject = isProjectFile(job.source.toStdString());
    State state = loaded.opened.state;
    if (!isWholeDocument(job.source))
        fitDepth(state, loaded.base, loaded);
    document.start(state, isProject ? QFileInfo(job.source).absoluteFilePath() : QString());
    if (job.counted)
        addToRecent(job.source);
}

void apply(const OpenState& job, const Loaded& loaded, Document& document)
{
    document.start(loaded.opened.state, job.file);
}

void apply(const OpenInto& job, const Loaded& loaded, Document& document)
{
    State next = document.state();
    bringMaps(next, loaded, isBuiltInSource(job.source.toStdString()));
    fitDepth(next, loaded.base, loaded);
    if (job.asStep || editedSince(job.before, document))
        document.edit(QObject::tr("Open %1").arg(QString::fromStdString(shownName(next.name))), [&](State& state) { state = next; });
    else
        document.start(next, {});
    addToRecent(job.source);
}

void apply(const EditNeeds& job, const Loaded& loaded, Document& document)
{
    document.edit(job.text, [&](State& state) {
        loaded.change(state);
        fitDepth(state, loaded.base, loaded);
    });
}

void apply(const Follow&, const Loaded&, Document&) { } // it is the data that changes
} // namespace

bool editedSince(const State& before, const Document& document)
{
    return bool(differences(before, document.state()) & ~(Changes(Change::Camera) | Change::Moment));
}

bool losesWork(const Job& job, const Document& document)
{
    const auto* opening = std::get_if<OpenDocument>(&job);
    const auto* state = std::get_if<OpenState>(&job);
    return (opening && editedSince(opening->before, document)) || (state && editedSince(state->before, document));
}

void applyLoaded(const Job& job, const Loaded& loaded, Document& document)
{
    std::visit([&](const auto& kind) { apply(kind, loaded, document); }, job);
}

void tellLoaded(const Job& job, const Loaded& loaded, Messages& messages)
{
    if (std::holds_alternative<Follow>(job))
        return;
    messages.clear("load");
    messages.set("assigned", isOpening(job) ? Warnings{} : loaded.opened.warnings);
    if (isOpening(job))
        messages.set("opened", loaded.opened.warnings);
}

void tellShown(const Shown& shown, Messages& messages)
{
    messages.set("missing", warningsOf(shown));
    messages.set("maps", shown.resources.material->warnings);
    messages.set("mesh", shown.resources.mesh->warnings);
}

void tellReadAgain(const Shown& shown, const FileStamps& before, Messages& messages)
{
    QStringList names;
    bool outside = false;
    for (const std::string& name : shown.readAgain) {
        const QString file = QFileInfo(QString::fromStdString(fileOfPicture(name).string())).fileName();
        if (!names.contains(file))
            names.append(file);
        const auto known = before.find(name);
        outside = outside || (known != before.end() && known->second != shown.files.at(name));
    }
    if (names.isEmpty())
        return;
    const QString files = names.join(", ");
    const QString told = names.size() == 1
        ? (outside ? QObject::tr("%1 was changed outside and has been read again.") : QObject::tr("%1 has been read again.")).arg(files)
        : (outside ? QObject::tr("%1 files were changed outside and have been read again: %2.")
                   : QObject::tr("%1 files have been read again: %2."))
              .arg(names.size())
              .arg(files);
    messages.set("files", QList<Message>{{.text = told, .isNote = true}});
}

void tellEdited(const State& state, const Resources* resources, Messages& messages)
{
    messages.clear("load");
    messages.clear("files");
    if (!resources)
        return;
    const auto tooDeepNow = tooDeep(state, *resources);
    messages.set("depth", tooDeepNow ? Warnings{*tooDeepNow} : Warnings{});
}

void tellFollowing(const QString& map, Messages& messages)
{
    if (map.isEmpty())
        messages.clear("follow");
    else
        messages.setNotice("follow", QObject::tr("The picture is drawn when the %1 has been made.").arg(map));
}

void tellStopped(const QString& map, Messages& messages)
{
    const QString told = map.isEmpty() ? QObject::tr("Loading was stopped; choose again what is not shown.")
                                       : QObject::tr("Making the %1 was stopped; choose the technique again.").arg(map);
    messages.set("follow", QList<Message>{{false, told}});
}

} // namespace relievo
