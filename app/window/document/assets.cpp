// Loading for the window: first the files, then the change.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/assets.h"
#include "app/window/document/recent_files.h"
#include "core/image/sets/texture_set.h"
#include <QFileInfo>
#include <algorithm>

namespace relievo {

struct Assets::Loaded {
    State base; // what it was read on
    Opened opened;
    Shown shown;
    std::optional<Error> error;
};

namespace {
bool hasMap(const Material& material, MapKind kind)
{
    return kind == MapKind::Height ? material.height.has_value() : material.map(kind) != nullptr;
}

// A file that `next` names anew but that could not be read.
std::optional<Error> newFileThatFailed(const State& before, const State& next, const Shown& shown)
{
    if (shown.mesh && next.mesh != before.mesh)
        return shown.mesh->why;
    if (shown.environment && next.environment != before.environment)
        return shown.environment->why;
    const Material& material = *shown.resources.material;
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = next.slots[std::size_t(row.kind)];
        if (slot.empty() || slot == before.slots[std::size_t(row.kind)] || hasMap(material, row.kind))
            continue;
        for (const Warning& warning : material.warnings)
            if (tellsOf(warning, slot.file))
                return Error{warning.text.ends_with('.') ? warning.text.substr(0, warning.text.size() - 1) : warning.text, "", ""};
        return Error{"the map could not be read", slot.file, "Choose another file"};
    }
    return {};
}

bool cancelled(const Error& error)
{
    return error.what == "cancelled";
}

bool isWhole(const QString& source)
{
    return isProjectFile(source.toStdString()) || source.startsWith("scene:");
}

// What a SOURCE of maps brings into `state`; it was read on `base`.
void takeMaps(State& state, const State& base, const Opened& source, bool builtIn)
{
    const State& opened = source.state;
    state.slots = opened.slots;
    state.name = opened.name;
    if (builtIn) // a sample brings its depth
        state.parameters.depth = opened.parameters.depth;
    if (opened.mesh != base.mesh) // a mesh with textures
        state.mesh = opened.mesh, state.part = opened.part, state.panes = opened.panes;
    if (!source.bringsValues)
        return;
    for (const ParameterRow& row : kParameters) // what was edited meanwhile stays
        if (const Value value = get(opened.parameters, row); value != get(base.parameters, row))
            set(state.parameters, row, value);
    if (opened.panes != base.panes)
        state.panes = opened.panes;
}

constexpr auto kNone = [](const auto&) { return false; };
} // namespace

Assets::Assets(Document& document, Messages& messages, QObject* parent) : QObject(parent), m_document(document), m_messages(messages)
{
    connect(&document, &Document::changed, this, &Assets::follow);
    connect(&document, &Document::choseAgain, this, [this] { // what was stopped or failed is tried once more
        if (m_background.busy() || !m_jobs.empty())
            return;
        m_followed.reset();
        check();
    });
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        m_following = false;
        const Error error{what.toStdString(), m_document.state().name, "Use smaller maps or meshes"};
        m_jobs.empty() ? m_messages.set("follow", error) : refuse(error);
        jobEnded();
    });
    connect(&m_background, &Background::busyChanged, this, [this](bool busy) {
        if (busy)
            return;
        if (std::exchange(m_following, false))
            return tellStopped();
        if (m_jobs.empty())
            return;
        m_jobs.clear(); // cancelled
        m_refused = true;
        Q_EMIT refused();
        endChanges();
        if (!ready()) // never an empty window
            openDocument("sample:bricks", State{}, false);
        else if (!fits(m_document.state()))
            tellStopped(); // what was to be followed after it
    });
}

Assets::Loaded Assets::open(const std::string& source, const State& base, const Shown& previous, const Progress& progress)
{
    Loaded result{base, {}, {}, {}};
    auto opened = openSource(source, base, progress.part(0.f, 0.6f));
    if (!opened) {
        result.error = opened.error();
        return result;
    }
    result.opened = std::move(*opened);
    auto shown = loadWhatIsThere(result.opened.state, result.opened.images, previous, progress.part(0.6f, 1.f));
    if (shown)
        result.shown = std::move(*shown);
    else
        result.error = shown.error();
    return result;
}

void Assets::openDocument(const QString& source)
{
    const bool whole = isWhole(source); // else the maps alone are replaced, also those of another opening of maps
    enqueue(Opening{source, m_document.state(), {}}, [whole](const Job& job) { return !job.change && (whole || !job.whole); });
}

void Assets::openDocument(const QString& source, const State& base, bool counted)
{
    enqueue(Opening{source, m_document.state(), base, counted}, [](const Job& job) { return !job.change; });
}

void Assets::openState(const State& state, const Warnings& warnings, const QString& file)
{
    const auto work = [this, state, warnings, file, before = m_document.state()](
                          const State&, const Shown& previous, const Progress& progress) -> Background::Then {
        Loaded loaded{state, Opened{state, {}, warnings}, {}, {}};
        if (const auto shown = loadWhatIsThere(state, {}, previous, progress))
            loaded.shown = *shown;
        else
            loaded.error = shown.error();
        return [this, state, file, before, loaded] { opened({{}, before, state, false, false, {}, file}, loaded); };
    };
    enqueue(Job{work, true}, [](const Job& job) { return !job.change; });
}

void Assets::openInto(const QString& source)
{
    if ((m_document.file().isEmpty() && !m_document.isModified()) || isWhole(source))
        return openDocument(source);
    enqueue(Opening{source, m_document.state(), {}, true, true}, [](const Job& job) { return !job.change && !job.whole; });
}

void Assets::propose(const QString& text, std::function<void(State&)> change, const Look& look)
{
    const auto work = [this, text, change, look](const State& now, const Shown& previous, const Progress& progress) -> Background::Then {
        DecodedImages images;
        Warnings warnings;
        const auto settled = look ? look(images, warnings) : change;
        State next = now;
        settled(next);
        const auto shown = loadWhatIsThere(next, images, previous, progress);
        return [this, text, settled, next, now, shown, warnings] {
            if (!shown)
                return refuse(shown.error());
            if (const auto error = newFileThatFailed(now, next, *shown))
                return refuse(*error);
            m_messages.clear("load");
            m_messages.set("assigned", warnings);
            take(*shown);
            m_document.edit(text, settled);
        };
    };
    const State now = m_document.state();
    State after = now;
    change(after);
    enqueue(Job{work, false, true, text, change, bool(look)},
        [&](const Job& job) { // another shape while one is loading, another file for the same map
            State both = now;
            if (job.change)
                job.change(both);
            change(both);
            return job.change && both == after;
        });
}

void Assets::assign(const QString& text, MapKind kind, const std::string& file)
{
    const auto put = [kind](const MapSlot& slot) { return [kind, slot](State& state) { state.slots[std::size_t(kind)] = slot; }; };
    if (file.empty())
        return propose(text, put({}));
    propose(text, put({file}),
        [put, kind, file](DecodedImages& images, Warnings& warnings) { return put(slotByHand(kind, file, images, warnings)); });
}

bool Assets::locatesMesh(const QString& file) const
{
    return missingMesh() && QFileInfo(file).fileName() == QFileInfo(QString::fromStdString(m_document.state().mesh)).fileName();
}

void Assets::dropChanges()
{
    if (!changesPending())
        return;
    while (changesPending())
        m_jobs.pop_front();
    m_refused = true;
    if (m_jobs.empty())
        m_background.cancel();
    runNext();
    Q_EMIT refused();
    endChanges();
}

void Assets::enqueue(Job job, const std::function<bool(const Job&)>& pointless)
{
    const bool runs = !m_jobs.empty() && !pointless(m_jobs.front());
    m_jobs.remove_if(pointless);
    m_jobs.push_back(std::move(job));
    if (!runs) {
        runNext();
        endChanges(); // what it made pointless may have been waited for
    }
}

void Assets::enqueue(const Opening& opening, const std::function<bool(const Job&)>& pointless)
{
    const auto work = [this, opening](const State& now, const Shown& previous, const Progress& progress) -> Background::Then {
        const State base = opening.base.value_or(now);
        const Loaded loaded = open(opening.source.toStdString(), base, previous, progress);
        return [this, opening, loaded] { opened(opening, loaded); };
    };
    enqueue(Job{work, opening.base || isWhole(opening.source), opening.asStep}, pointless);
}

// Proposals that need no more files are done at once; the first other job starts.
void Assets::runNext()
{
    while (!m_jobs.empty() && m_jobs.front().change) {
        State next = m_document.state();
        m_jobs.front().change(next);
        if (!holds(next) || m_jobs.front().looks)
            break;
        const Job job = std::move(m_jobs.front());
        m_jobs.pop_front();
        m_messages.clear("load");
        m_messages.clear("assigned");
        m_document.edit(job.text, job.change);
    }
    if (m_jobs.empty())
        return check();
    if (m_background.busy())
        m_followed.reset(), m_following = false; // is followed again after this
    m_background.start(
        [this, work = m_jobs.front().work, now = m_document.state(), previous = m_shown](const Progress& progress) -> Background::Then {
            return [this, then = work(now, previous, progress)] {
                then();
                jobEnded();
            };
        });
}

void Assets::jobEnded()
{
    if (!m_jobs.empty())
        m_jobs.pop_front();
    runNext();
    endChanges();
}

void Assets::endChanges()
{
    if (!changesPending())
        Q_EMIT changesEnded(!std::exchange(m_refused, false));
}

void Assets::opened(const Opening& opening, const Loaded& loaded)
{
    if (loaded.error) {
        refuse(*loaded.error);
        if (!ready() && !opening.instead) // never an empty window
            enqueue(Opening{"sample:bricks", m_document.state(), State{}, false, false, loaded.error}, kNone);
        return;
    }
    const bool edited(differences(opening.before, m_document.state()) & ~(Changes(Change::Camera) | Change::Moment));
    if (edited && askFirst && (opening.base || isWhole(opening.source)))
        askFirst([this, opening, loaded] { show(opening, loaded, false); });
    else
        show(opening, loaded, edited);
}

void Assets::show(const Opening& opening, const Loaded& loaded, bool edited)
{
    const std::string source = opening.source.toStdString();
    const bool builtIn = isBuiltInSource(source);
    m_messages.clear("load");
    m_messages.clear("assigned");
    m_messages.set("opened", loaded.opened.warnings);
    take(loaded.shown);
    const State& next = loaded.opened.state;
    State present = m_document.state();
    takeMaps(present, loaded.base, loaded.opened, builtIn);
    if (opening.base || isWhole(opening.source))
        m_document.start(next, isProjectFile(source) ? QFileInfo(opening.source).absoluteFilePath() : opening.file);
    else if (opening.asStep || edited)
        m_document.edit(tr("Open %1").arg(QString::fromStdString(next.name)), [&](State& state) { state = present; });
    else
        m_document.start(present, {});
    if (opening.instead) // after the edit, which clears it
        m_messages.set("load", *opening.instead);
    if (opening.counted && !builtIn)
        addRecentFile(QFileInfo(opening.source).absoluteFilePath());
    check();
}

void Assets::take(const Shown& shown)
{
    m_shown = shown;
    m_messages.set("missing", warningsOf(shown));
    m_messages.set("maps", resources().material->warnings);
    m_messages.set("mesh", resources().mesh->warnings);
    Q_EMIT resourcesChanged();
}

void Assets::refuse(const Error& error)
{
    if (!cancelled(error))
        m_messages.set("load", error);
    m_refused = true;
    Q_EMIT refused();
}

} // namespace relievo
