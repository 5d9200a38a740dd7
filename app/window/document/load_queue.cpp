// The rules of the queue.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/load_queue.h"
#include <algorithm>
#include <utility>

namespace relievo {
namespace {
bool follows(const Job& job)
{
    return std::holds_alternative<Follow>(job);
}

// Whether nothing of `earlier` is left to be seen once `later` is done too.
bool leavesNothingOf(const EditNeeds& earlier, const EditNeeds& later, const State& now)
{
    State alone = now, both = now;
    later.change(alone);
    earlier.change(both);
    later.change(both);
    return both == alone;
}

bool makesPointless(const Job& later, const Job& earlier, const State& now)
{
    if (replacesDocument(later))
        return isOpening(earlier);
    if (std::holds_alternative<OpenInto>(later))
        return std::holds_alternative<OpenInto>(earlier);
    if (follows(later))
        return follows(earlier);
    const auto* edit = std::get_if<EditNeeds>(&earlier);
    return edit && leavesNothingOf(*edit, std::get<EditNeeds>(later), now);
}
} // namespace

JobId LoadQueue::request(Job job, const State& now)
{
    const JobId id = m_states.size();
    m_states.push_back(JobState::Waiting);
    if (const auto* follow = std::get_if<Follow>(&job)) {
        if (hasRequests() || m_followed == follow->needs) {
            m_states[id] = JobState::Pointless;
            return id;
        }
        m_followed = follow->needs;
    }
    for (auto earlier = m_jobs.begin(); earlier != m_jobs.end();)
        earlier = makesPointless(job, earlier->job, now) ? remove(earlier, JobState::Pointless) : std::next(earlier);
    const auto following = std::ranges::find_if(m_jobs, follows, &QueuedJob::job);
    m_jobs.insert(following, {id, std::move(job)});
    return id;
}

std::optional<EditNeeds> LoadQueue::nextDoneAtOnce(const State& now, const std::function<bool(const State&)>& isLoaded)
{
    const auto* edit = m_jobs.empty() || runs(m_jobs.front()) ? nullptr : std::get_if<EditNeeds>(&m_jobs.front().job);
    if (!edit || edit->look)
        return {};
    State next = now;
    edit->change(next);
    if (!isLoaded(next))
        return {};
    const EditNeeds done = *edit;
    remove(m_jobs.begin(), JobState::Done);
    return done;
}

const QueuedJob* LoadQueue::startNext()
{
    if (m_jobs.empty() || runs(m_jobs.front()))
        return nullptr;
    if (running()) { // following, which is looked at again when the requests have ended
        remove(std::prev(m_jobs.end()), JobState::Pointless);
        m_followed.reset();
    }
    m_states[m_jobs.front().id] = JobState::Running;
    return &m_jobs.front();
}

const QueuedJob* LoadQueue::running() const
{
    const auto job = std::ranges::find_if(m_jobs, [this](const QueuedJob& one) { return runs(one); });
    return job == m_jobs.end() ? nullptr : &*job;
}

std::optional<Job> LoadQueue::end(JobId id, JobState how)
{
    const auto ended = std::ranges::find(m_jobs, id, &QueuedJob::id);
    if (ended == m_jobs.end() || !runs(*ended))
        return {};
    Job job = std::move(ended->job);
    if (isChange(job) && how != JobState::Done)
        m_allMade = false;
    remove(ended, how);
    return job;
}

void LoadQueue::cancel()
{
    m_allMade = m_allMade && std::ranges::none_of(m_jobs, isChange, &QueuedJob::job);
    while (!m_jobs.empty())
        remove(m_jobs.begin(), JobState::Cancelled);
}

void LoadQueue::dropChanges()
{
    while (changesPending()) {
        m_allMade = false;
        remove(m_jobs.begin(), JobState::Cancelled);
    }
}

bool LoadQueue::hasRequests() const
{
    return !m_jobs.empty() && !follows(m_jobs.front().job);
}

bool LoadQueue::hasOpenings() const
{
    return std::ranges::any_of(m_jobs, isOpening, &QueuedJob::job);
}

bool LoadQueue::changesPending() const
{
    return !m_jobs.empty() && isChange(m_jobs.front().job);
}

bool LoadQueue::allChangesMade()
{
    return std::exchange(m_allMade, true);
}

void LoadQueue::stopFollowing()
{
    m_followed.reset();
    if (!m_jobs.empty() && follows(m_jobs.back().job))
        remove(std::prev(m_jobs.end()), JobState::Pointless);
}

void LoadQueue::dontFollow(const Needs& needs)
{
    m_followed = needs;
}

void LoadQueue::followAgain()
{
    m_followed.reset();
}

LoadQueue::Jobs::iterator LoadQueue::remove(Jobs::iterator job, JobState how)
{
    m_states[job->id] = how;
    return m_jobs.erase(job);
}

} // namespace relievo
