// Loading for the window: first the files, then the change.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/assets.h"
#include <utility>

namespace relievo {

Assets::Assets(Document& document, Messages& messages, QObject* parent) : QObject(parent), m_document(document), m_messages(messages)
{
    connect(&document, &Document::changed, this, &Assets::documentChanged);
    connect(&document, &Document::choseAgain, this, &Assets::choseAgain);
    connect(&m_watch, &FileWatch::changed, this, &Assets::filesChanged);
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        if (const QueuedJob* job = m_queue.running())
            end(job->id, Error{what.toStdString(), m_document.state().name, "Use smaller maps or meshes"});
    });
    connect(&m_background, &Background::busyChanged, this, [this](bool busy) {
        if (!busy)
            drawEarly({});
        if (!busy && m_queue.running()) // else its end is known
            cancelled();
    });
}

void Assets::openDocument(const QString& source)
{
    if (!isWholeDocument(source))
        return request(OpenInto{.source = source, .before = m_document.state()});
    request(OpenDocument{.source = source, .before = m_document.state(), .base = State{}}); // it says all, or means the default
}

void Assets::openInto(const QString& source, bool onlyMaterial)
{
    if (isWholeDocument(source))
        return openDocument(source);
    const bool holdsWork = !m_document.file().isEmpty() || m_document.isModified();
    request(OpenInto{.source = source, .before = m_document.state(), .asStep = holdsWork, .onlyMaterial = onlyMaterial});
}

void Assets::dropChanges()
{
    if (!changesPending())
        return;
    m_queue.dropChanges();
    runNext();
    Q_EMIT refused();
    endChanges();
}

void Assets::request(Job job)
{
    m_queue.request(std::move(job), m_document.state());
    runNext();
    endChanges(); // what it made pointless may have been waited for
}

// Edits that need no files are done at once; the first other job starts, unless one runs.
void Assets::runNext()
{
    while (const auto edit = m_queue.nextDoneAtOnce(m_document.state(), [this](const State& state) { return m_store.isLoaded(state); })) {
        m_messages.clear("load");
        m_messages.clear("assigned");
        m_document.edit(edit->text, edit->change);
    }
    if (const QueuedJob* next = m_queue.startNext())
        start(*next, tr("Loading"));
    else if (!m_queue.hasRequests())
        follow();
    if (!m_queue.running())
        m_background.cancel(); // its work has become pointless
}

void Assets::start(const QueuedJob& job, const QString& what)
{
    drawEarly({});
    const auto work = [this, job, now = m_document.state(), previous = m_store.shown()](const Progress& progress) -> Background::Then {
        const auto early = [&](const Loaded& part) {
            const auto draw = [this, stop = progress.stop, picture = EarlyPicture{job.job, part}] {
                if (!stop.stop_requested())
                    drawEarly(picture);
            };
            QMetaObject::invokeMethod(this, draw, Qt::QueuedConnection); // comes before the end
        };
        const Expected<Loaded> loaded = load(job.job, now, previous, progress, early);
        return [this, job, loaded] {
            if (!loaded)
                return end(job.id, loaded.error());
            finish(job.job, *loaded);
            end(job.id, {});
        };
    };
    m_background.start(work, what);
}

void Assets::drawEarly(std::optional<EarlyPicture> picture)
{
    if (!picture && !m_early)
        return;
    m_early = std::move(picture);
    Q_EMIT earlyChanged();
}

void Assets::end(JobId id, const std::optional<Error>& why)
{
    const std::optional<Job> job = m_queue.end(id, why ? JobState::Refused : JobState::Done);
    if (job && why)
        tellRefused(*job, *why);
    runNext();
    endChanges();
}

void Assets::tellRefused(const Job& job, const Error& why)
{
    if (std::holds_alternative<Follow>(job))
        return m_messages.set("follow", why);
    m_messages.set("load", why);
    Q_EMIT refused();
    if (isOpening(job) && !ready() && !m_queue.hasOpenings() && !standsInForAnother(job))
        m_queue.request(firstDocument(m_document.state(), why), m_document.state());
}

void Assets::cancelled()
{
    const bool followed = !m_queue.hasRequests();
    m_queue.cancel();
    if (followed)
        return stopped();
    Q_EMIT refused();
    endChanges();
    if (!ready())
        request(firstDocument(m_document.state()));
    else if (!m_store.isComplete(m_document.state()))
        stopped(); // what was to be followed after it
}

void Assets::endChanges()
{
    if (!changesPending())
        Q_EMIT changesEnded(m_queue.allChangesMade());
}

// Asks first when work would be lost that was done meanwhile.
void Assets::finish(const Job& job, const Loaded& loaded)
{
    const auto bring = [this, job, loaded] {
        tellLoaded(job, loaded, m_messages);
        const Before before{m_store.shown().files, m_document.state(), m_document.began()};
        show(loaded.shown);
        applyLoaded(job, loaded, m_document);
        tellApplied(job, loaded, before, m_document, m_messages);
    };
    if (!askFirst || !losesWork(job, m_document))
        return bring();
    askFirst([this, bring] { // answered when other jobs may have ended
        bring();
        follow();
    });
}

void Assets::show(const Shown& shown)
{
    m_store.show(shown);
    m_watch.watch(shown.files);
    tellShown(shown, m_messages);
    Q_EMIT resourcesChanged();
}

void Assets::documentChanged(Changes what)
{
    const Changes work = what & ~(Changes(Change::Camera) | Change::Moment);
    if (work)
        tellEdited(m_document.state(), ready() ? &resources() : nullptr, m_messages);
    if (work & ~(Changes(Change::View) | Change::Name))
        follow();
}

void Assets::filesChanged(const FileNames& files)
{
    m_store.readAgain(files);
    m_queue.followAgain();
    follow();
}

// What was stopped or failed is tried once more.
void Assets::choseAgain()
{
    if (m_background.busy() || m_queue.hasRequests())
        return;
    m_queue.followAgain();
    follow();
}

// Undo, redo and pasted States name other files than those that are loaded, another technique searches with another map.
void Assets::follow()
{
    if (!ready() || m_queue.hasRequests()) // the last job's end looks again
        return;
    const State& now = m_document.state();
    if (m_store.isComplete(now)) {
        m_queue.stopFollowing();
        m_messages.clear("follow");
        return m_background.cancel(); // it is pointless
    }
    m_queue.request(Follow{.needs = needsOf(now)}, now);
    const QueuedJob* job = m_queue.startNext();
    if (!job)
        return;
    const QString map = m_store.missingMap(now);
    tellFollowing(map, m_messages);
    start(*job, map.isEmpty() ? tr("Loading") : tr("Making the %1").arg(map));
}

void Assets::stopped()
{
    m_queue.dontFollow(needsOf(m_document.state())); // until it is chosen again
    tellStopped(m_store.missingMap(m_document.state()), m_messages);
}

} // namespace relievo
