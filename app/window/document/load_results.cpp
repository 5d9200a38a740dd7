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

// A mesh that is new to the document starts with a relief that fits it, unless the file says how deep its own is.
void fitDepth(State& state, const Loaded& loaded)
{
    if (loaded.shown.mesh || loaded.opened.bringsValues)
        return;
    const float fits = fittingDepth(state.parameters, loaded.shown.resources.mesh->metresPerUV, loaded.shown.resources.fit);
    if (!(state.parameters.depth > fits))
        return;
    const double unit = std::pow(10., std::floor(std::log10(double(fits))) - 1.); // two digits
    state.parameters.depth = float(std::floor(double(fits) / unit) * unit);
}

State broughtBy(const OpenDocument& job, const Loaded& loaded, const State&)
{
    State state = loaded.opened.state;
    if (!isWholeDocument(job.source) && state.mesh != loaded.base.mesh)
        fitDepth(state, loaded);
    return state;
}

// What a SOURCE brings; what was edited while it was read stays.
State broughtBy(const OpenInto& job, const Loaded& loaded, const State& now)
{
    State next = loaded.opened.state;
    next.camera = now.camera;
    for (const ParameterRow& row : kParameters)
        if (const Value value = get(now.parameters, row); value != get(job.before.parameters, row))
            set(next.parameters, row, value);
    if (now.panes != job.before.panes)
        next.panes = now.panes;
    if (now.environment != job.before.environment)
        next.environment = now.environment;
    if (now.mesh != job.before.mesh && next.mesh == loaded.base.mesh)
        next.mesh = now.mesh, next.part = now.part;
    if (next.parameters.depth == loaded.opened.state.parameters.depth)
        fitDepth(next, loaded);
    return next;
}

template <class Kind> State broughtBy(const Kind&, const Loaded& loaded, const State&)
{
    return loaded.opened.state;
}

void apply(const OpenDocument& job, const Loaded& loaded, Document& document)
{
    const bool isProject = isProjectFile(job.source.toStdString());
    document.start(broughtBy(job, loaded, document.state()), isProject ? QFileInfo(job.source).absoluteFilePath() : QString());
    if (job.counted)
        addToRecent(job.source);
}

void apply(const OpenState& job, const Loaded& loaded, Document& document)
{
    document.start(loaded.opened.state, job.file);
}

void apply(const OpenInto& job, const Loaded& loaded, Document& document)
{
    const State next = broughtBy(job, loaded, document.state());
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
        if (state.mesh != loaded.base.mesh)
            fitDepth(state, loaded);
    });
}

void apply(const Follow&, const Loaded&, Document&) { } // it is the data that changes

// Of the files that were stale and have been read; before: how they were when they were read last.
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

void offerToKeep(const Job& job, const Before& before, Document& document, Messages& messages)
{
    const Parameters &kept = before.state.parameters, &given = before.began.parameters, &now = document.state().parameters;
    const auto differs = [&kept](const Parameters& other) { return kept.depth != other.depth || kept.tiling != other.tiling; };
    if (!std::holds_alternative<OpenInto>(job) || !differs(given) || !differs(now))
        return;
    const auto keep = [&document, depth = kept.depth, tiling = kept.tiling] {
        document.edit(QObject::tr("Keep depth and tiling"), [=](State& state) {
            state.parameters.depth = depth;
            state.parameters.tiling = tiling;
        });
    };
    messages.set("kept",
        QList<Message>{{.text = QObject::tr("Depth and tiling are those of what was opened; before they were %1 and %2.")
                                    .arg(double(kept.depth), 0, 'g', 3)
                                    .arg(double(kept.tiling), 0, 'g', 3),
            .isNote = true,
            .choices = {{QObject::tr("Keep depth and tiling"), keep}}}});
}
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

State broughtBy(const Job& job, const Loaded& loaded, const State& now)
{
    return std::visit([&](const auto& kind) { return broughtBy(kind, loaded, now); }, job);
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
    messages.set("environment", shown.resources.environment->warnings);
}

void tellApplied(const Job& job, const Loaded& loaded, const Before& before, Document& document, Messages& messages)
{
    tellReadAgain(loaded.shown, before.files, messages);
    offerToKeep(job, before, document, messages);
    if (const auto* opening = std::get_if<OpenDocument>(&job); opening && opening->insteadOf)
        messages.set("load", *opening->insteadOf);
}

void tellEdited(const State& state, const Resources* resources, Messages& messages)
{
    for (const char* source : {"load", "files", "kept"})
        messages.clear(source);
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
