// Which job runs, and what a second request does to the first: it waits, makes it pointless, is done at once or changes nothing.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/load_jobs.h"
#include <list>

namespace relievo {

enum class JobState {
    Waiting, // for those before it
    Running, // one at a time
    Done,
    Refused, // it could not be done; document and data stay as they were
    Cancelled, // by the user, or dropped
    Pointless, // a later request leaves nothing of it to be seen, or what it asks for is under way
};

using JobId = std::size_t;
struct QueuedJob {
    JobId id;
    Job job;
};

// The rules, in order:
// - A job waits until those before it have ended. Following the data runs only while nothing else is asked for, whose end looks again.
// - A document that is opened makes earlier openings pointless; maps that are opened make earlier maps pointless, but no document.
// - An edit makes those earlier edits pointless of which it leaves nothing: another shape, another file for the same map.
// - Edits never make openings pointless, nor openings edits: what is asked for in turn comes in turn.
// - An edit whose turn comes when its files are loaded already is done at once, unless it wants to look at one.
// - What was followed to no good end is not followed again before the data fitted in between, or somebody asks for it.
// A plain value without threads and signals; the tests hold every combination of two requests in one table (load_queue_test.cpp).
class LoadQueue {
public:
    // now: the present State of the document.
    JobId request(Job job, const State& now);

    // The edit whose turn it is and that needs no files; it counts as done. isLoaded: whether the files of a State are loaded.
    std::optional<EditNeeds> nextDoneAtOnce(const State& now, const std::function<bool(const State&)>& isLoaded);
    // The job that is to run from now on, in place of any that ran; nullptr: that one goes on.
    const QueuedJob* startNext();
    const QueuedJob* running() const;

    // Of the one that runs. Nothing when it has been overtaken meanwhile: then its result is not wanted either.
    std::optional<Job> end(JobId id, JobState how);
    void cancel(); // the user stops the running one; those that wait for it go too
    void dropChanges(); // those that are pending

    bool hasRequests() const; // anything but following
    bool hasOpenings() const;
    bool changesPending() const; // edits that run, or wait for edits only: they will come to the present document
    bool allChangesMade(); // since this was last asked: none was refused, cancelled or dropped

    void stopFollowing(); // the data fits
    void dontFollow(const Needs& needs); // until the data fits, or
    void followAgain();

    JobState state(JobId id) const { return m_states[id]; } // of any job that was ever asked for

private:
    using Jobs = std::list<QueuedJob>;
    bool runs(const QueuedJob& job) const { return state(job.id) == JobState::Running; }
    Jobs::iterator remove(Jobs::iterator job, JobState how);
    Jobs m_jobs; // that wait or run, in order; following stands last, and only there something runs that is not the first
    std::vector<JobState> m_states; // by JobId
    std::optional<Needs> m_followed; // what was last followed, to whatever end
    bool m_allMade = true;
};

} // namespace relievo
