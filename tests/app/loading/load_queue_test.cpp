// Every second request while a first one runs, as a table: what becomes of both, and of the document.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/load_queue.h"
#include <algorithm>
#include <array>
#include <gtest/gtest.h>

using namespace relievo;

namespace {
static_assert(std::variant_size_v<Job> == 5, "another kind of job: it stands in First and Second, and wants rows");

// What runs.
enum class First { Nothing, Document, State, Maps, MapsAsStep, Height, Follow };
// What happens then. Height and Color are edits whose files must be read, Ready is one that needs none, Look one that looks at its
// file all the same; Follow wants what the running one follows, FollowOther something else; Fits: the document fits the data again.
enum class Second { Document, State, Maps, MapsAsStep, Height, Color, Ready, Look, Follow, FollowOther, Fits, Cancel, Drop };
constexpr int kFirsts = int(First::Follow) + 1, kSeconds = int(Second::Drop) + 1;

using enum JobState;
constexpr std::optional<JobState> kNone; // no job: the second is a click, or nothing ran

struct Row {
    First first;
    Second second;
    std::optional<JobState> firstAtOnce, secondAtOnce; // just after the second request
    std::optional<JobState> firstInTheEnd, secondInTheEnd; // when all files that are still wanted have been read
    const char* document; // in the end: name, height map, colour map
};

// Following is not asked for again here: Assets does that when the queue has no more requests.
constexpr auto kRows = std::to_array<Row>({
    {First::Nothing, Second::Document, kNone, Running, kNone, Done, "document - -"},
    {First::Nothing, Second::State, kNone, Running, kNone, Done, "state - -"},
    {First::Nothing, Second::Maps, kNone, Running, kNone, Done, "maps2 maps2 maps2"},
    {First::Nothing, Second::MapsAsStep, kNone, Running, kNone, Done, "maps2 maps2 maps2"},
    {First::Nothing, Second::Height, kNone, Running, kNone, Done, "start height2 -"},
    {First::Nothing, Second::Color, kNone, Running, kNone, Done, "start - color"},
    {First::Nothing, Second::Ready, kNone, Done, kNone, Done, "ready - -"},
    {First::Nothing, Second::Look, kNone, Running, kNone, Done, "look - -"},
    {First::Nothing, Second::Follow, kNone, Running, kNone, Done, "start - -"},
    {First::Nothing, Second::FollowOther, kNone, Running, kNone, Done, "start - -"},
    {First::Nothing, Second::Fits, kNone, kNone, kNone, kNone, "start - -"},
    {First::Nothing, Second::Cancel, kNone, kNone, kNone, kNone, "start - -"},
    {First::Nothing, Second::Drop, kNone, kNone, kNone, kNone, "start - -"},

    // A document that is being opened: another one overtakes it, all else comes to it afterwards.
    {First::Document, Second::Document, Pointless, Running, Pointless, Done, "document - -"},
    {First::Document, Second::State, Pointless, Running, Pointless, Done, "state - -"},
    {First::Document, Second::Maps, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::Document, Second::MapsAsStep, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::Document, Second::Height, Running, Waiting, Done, Done, "document height2 -"},
    {First::Document, Second::Color, Running, Waiting, Done, Done, "document - color"},
    {First::Document, Second::Ready, Running, Waiting, Done, Done, "ready - -"},
    {First::Document, Second::Look, Running, Waiting, Done, Done, "look - -"},
    {First::Document, Second::Follow, Running, Pointless, Done, Pointless, "document - -"},
    {First::Document, Second::FollowOther, Running, Pointless, Done, Pointless, "document - -"},
    {First::Document, Second::Fits, Running, kNone, Done, kNone, "document - -"},
    {First::Document, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::Document, Second::Drop, Running, kNone, Done, kNone, "document - -"},

    {First::State, Second::Document, Pointless, Running, Pointless, Done, "document - -"},
    {First::State, Second::State, Pointless, Running, Pointless, Done, "state - -"},
    {First::State, Second::Maps, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::State, Second::MapsAsStep, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::State, Second::Height, Running, Waiting, Done, Done, "state height2 -"},
    {First::State, Second::Color, Running, Waiting, Done, Done, "state - color"},
    {First::State, Second::Ready, Running, Waiting, Done, Done, "ready - -"},
    {First::State, Second::Look, Running, Waiting, Done, Done, "look - -"},
    {First::State, Second::Follow, Running, Pointless, Done, Pointless, "state - -"},
    {First::State, Second::FollowOther, Running, Pointless, Done, Pointless, "state - -"},
    {First::State, Second::Fits, Running, kNone, Done, kNone, "state - -"},
    {First::State, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::State, Second::Drop, Running, kNone, Done, kNone, "state - -"},

    // Maps that are being opened: documents and other maps overtake them.
    {First::Maps, Second::Document, Pointless, Running, Pointless, Done, "document - -"},
    {First::Maps, Second::State, Pointless, Running, Pointless, Done, "state - -"},
    {First::Maps, Second::Maps, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::Maps, Second::MapsAsStep, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::Maps, Second::Height, Running, Waiting, Done, Done, "maps1 height2 maps1"},
    {First::Maps, Second::Color, Running, Waiting, Done, Done, "maps1 maps1 color"},
    {First::Maps, Second::Ready, Running, Waiting, Done, Done, "ready maps1 maps1"},
    {First::Maps, Second::Look, Running, Waiting, Done, Done, "look maps1 maps1"},
    {First::Maps, Second::Follow, Running, Pointless, Done, Pointless, "maps1 maps1 maps1"},
    {First::Maps, Second::FollowOther, Running, Pointless, Done, Pointless, "maps1 maps1 maps1"},
    {First::Maps, Second::Fits, Running, kNone, Done, kNone, "maps1 maps1 maps1"},
    {First::Maps, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::Maps, Second::Drop, Running, kNone, Done, kNone, "maps1 maps1 maps1"},

    // The same as a step of undo: dropped with the changes of the document.
    {First::MapsAsStep, Second::Document, Pointless, Running, Pointless, Done, "document - -"},
    {First::MapsAsStep, Second::State, Pointless, Running, Pointless, Done, "state - -"},
    {First::MapsAsStep, Second::Maps, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::MapsAsStep, Second::MapsAsStep, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::MapsAsStep, Second::Height, Running, Waiting, Done, Done, "maps1 height2 maps1"},
    {First::MapsAsStep, Second::Color, Running, Waiting, Done, Done, "maps1 maps1 color"},
    {First::MapsAsStep, Second::Ready, Running, Waiting, Done, Done, "ready maps1 maps1"},
    {First::MapsAsStep, Second::Look, Running, Waiting, Done, Done, "look maps1 maps1"},
    {First::MapsAsStep, Second::Follow, Running, Pointless, Done, Pointless, "maps1 maps1 maps1"},
    {First::MapsAsStep, Second::FollowOther, Running, Pointless, Done, Pointless, "maps1 maps1 maps1"},
    {First::MapsAsStep, Second::Fits, Running, kNone, Done, kNone, "maps1 maps1 maps1"},
    {First::MapsAsStep, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::MapsAsStep, Second::Drop, Cancelled, kNone, Cancelled, kNone, "start - -"},

    // An edit: only another one that leaves nothing of it overtakes it.
    {First::Height, Second::Document, Running, Waiting, Done, Done, "document - -"},
    {First::Height, Second::State, Running, Waiting, Done, Done, "state - -"},
    {First::Height, Second::Maps, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::Height, Second::MapsAsStep, Running, Waiting, Done, Done, "maps2 maps2 maps2"},
    {First::Height, Second::Height, Pointless, Running, Pointless, Done, "start height2 -"},
    {First::Height, Second::Color, Running, Waiting, Done, Done, "start height1 color"},
    {First::Height, Second::Ready, Running, Waiting, Done, Done, "ready height1 -"},
    {First::Height, Second::Look, Running, Waiting, Done, Done, "look height1 -"},
    {First::Height, Second::Follow, Running, Pointless, Done, Pointless, "start height1 -"},
    {First::Height, Second::FollowOther, Running, Pointless, Done, Pointless, "start height1 -"},
    {First::Height, Second::Fits, Running, kNone, Done, kNone, "start height1 -"},
    {First::Height, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::Height, Second::Drop, Cancelled, kNone, Cancelled, kNone, "start - -"},

    // Following: all that needs files goes first; what needs none lets it go on.
    {First::Follow, Second::Document, Pointless, Running, Pointless, Done, "document - -"},
    {First::Follow, Second::State, Pointless, Running, Pointless, Done, "state - -"},
    {First::Follow, Second::Maps, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::Follow, Second::MapsAsStep, Pointless, Running, Pointless, Done, "maps2 maps2 maps2"},
    {First::Follow, Second::Height, Pointless, Running, Pointless, Done, "start height2 -"},
    {First::Follow, Second::Color, Pointless, Running, Pointless, Done, "start - color"},
    {First::Follow, Second::Ready, Running, Done, Done, Done, "ready - -"},
    {First::Follow, Second::Look, Pointless, Running, Pointless, Done, "look - -"},
    {First::Follow, Second::Follow, Running, Pointless, Done, Pointless, "start - -"},
    {First::Follow, Second::FollowOther, Pointless, Running, Pointless, Done, "start - -"},
    {First::Follow, Second::Fits, Pointless, kNone, Pointless, kNone, "start - -"},
    {First::Follow, Second::Cancel, Cancelled, kNone, Cancelled, kNone, "start - -"},
    {First::Follow, Second::Drop, Running, kNone, Done, kNone, "start - -"},
});

consteval bool hasEachCombinationOnce()
{
    for (int first = 0; first < kFirsts; ++first)
        for (int second = 0; second < kSeconds; ++second)
            if (std::ranges::count_if(kRows, [&](const Row& row) { return row.first == First(first) && row.second == Second(second); })
                != 1)
                return false;
    return kRows.size() == std::size_t(kFirsts * kSeconds);
}
static_assert(hasEachCombinationOnce(), "a combination of two requests without a row, or with two");

std::string& file(State& state, MapKind kind)
{
    return state.slots[std::size_t(kind)].file;
}

// A document, the queue that works for it, and files that are read at a word.
class Desk {
public:
    std::optional<JobId> request(First what)
    {
        switch (what) {
        case First::Nothing:
            return {};
        case First::Document:
            return add(OpenDocument{.source = "document", .before = m_document});
        case First::State:
            return add(OpenState{.state = named("state"), .before = m_document});
        case First::Maps:
            return add(OpenInto{.source = "maps1", .before = m_document});
        case First::MapsAsStep:
            return add(OpenInto{.source = "maps1", .before = m_document, .asStep = true});
        case First::Height:
            return add(put(MapKind::Height, "height1"));
        case First::Follow:
            return add(Follow{.needs = needsOf(named("wanted"))});
        }
        return {};
    }
    std::optional<JobId> request(Second what)
    {
        switch (what) {
        case Second::Document:
            return request(First::Document);
        case Second::State:
            return request(First::State);
        case Second::Maps:
            return add(OpenInto{.source = "maps2", .before = m_document});
        case Second::MapsAsStep:
            return add(OpenInto{.source = "maps2", .before = m_document, .asStep = true});
        case Second::Height:
            return add(put(MapKind::Height, "height2"));
        case Second::Color:
            return add(put(MapKind::Color, "color"));
        case Second::Ready:
            return add(rename("ready"));
        case Second::Look: {
            EditNeeds edit = rename("look");
            edit.look = [change = edit.change](DecodedImages&, Warnings&) { return change; };
            return add(edit);
        }
        case Second::Follow:
            return request(First::Follow);
        case Second::FollowOther: {
            State other;
            other.mesh = "torus";
            return add(Follow{.needs = needsOf(other)});
        }
        case Second::Fits:
            m_queue.stopFollowing();
            break;
        case Second::Cancel:
            m_queue.cancel();
            break;
        case Second::Drop:
            m_queue.dropChanges();
            break;
        }
        proceed();
        return {};
    }
    void finishAll()
    {
        while (const QueuedJob* job = m_queue.running()) {
            const JobId id = job->id;
            std::visit([this](const auto& kind) { apply(kind); }, job->job);
            m_loaded = m_document.slots;
            EXPECT_TRUE(m_queue.end(id, Done));
            proceed();
        }
    }
    std::optional<JobState> state(std::optional<JobId> id) const { return id ? std::optional(m_queue.state(*id)) : kNone; }
    std::string document()
    {
        const auto shown = [](const std::string& name) { return name.empty() ? "-" : name; };
        return m_document.name + ' ' + shown(file(m_document, MapKind::Height)) + ' ' + shown(file(m_document, MapKind::Color));
    }
    LoadQueue& queue() { return m_queue; }

private:
    static State named(const char* name)
    {
        State state;
        state.name = name;
        return state;
    }
    static EditNeeds put(MapKind kind, const char* name)
    {
        return {.text = "Assign", .change = [kind, name](State& state) { file(state, kind) = name; }};
    }
    static EditNeeds rename(const char* name)
    {
        return {.text = "Rename", .change = [name](State& state) { state.name = name; }};
    }
    JobId add(Job job)
    {
        const JobId id = m_queue.request(std::move(job), m_document);
        proceed();
        return id;
    }
    void proceed()
    {
        while (const auto edit = m_queue.nextDoneAtOnce(m_document, [this](const State& state) { return state.slots == m_loaded; }))
            edit->change(m_document);
        m_queue.startNext();
    }
    void apply(const OpenDocument& job) { m_document = named(job.source.toLatin1().constData()); }
    void apply(const OpenState& job) { m_document = job.state; }
    void apply(const OpenInto& job)
    {
        m_document.name = job.source.toStdString();
        file(m_document, MapKind::Height) = file(m_document, MapKind::Color) = m_document.name;
    }
    void apply(const EditNeeds& job) { job.change(m_document); }
    void apply(const Follow&) { }

    State m_document = named("start");
    MapSlots m_loaded = m_document.slots;
    LoadQueue m_queue;
};
} // namespace

TEST(LoadQueue, ASecondRequestWhileTheFirstRuns)
{
    for (const Row& row : kRows) {
        SCOPED_TRACE("first " + std::to_string(int(row.first)) + ", second " + std::to_string(int(row.second)));
        Desk desk;
        const auto first = desk.request(row.first);
        const auto second = desk.request(row.second);
        EXPECT_EQ(desk.state(first), row.firstAtOnce);
        EXPECT_EQ(desk.state(second), row.secondAtOnce);
        desk.finishAll();
        EXPECT_EQ(desk.state(first), row.firstInTheEnd);
        EXPECT_EQ(desk.state(second), row.secondInTheEnd);
        EXPECT_EQ(desk.document(), row.document);
        EXPECT_FALSE(desk.queue().hasRequests());
    }
}

TEST(LoadQueue, ARefusalTakesNothingElseWithIt)
{
    Desk desk;
    const auto first = desk.request(First::Height);
    const auto second = desk.request(Second::Color);
    ASSERT_TRUE(desk.queue().end(*first, Refused));
    EXPECT_FALSE(desk.queue().end(*first, Done)) << "it has ended";
    desk.queue().startNext();
    desk.finishAll();
    EXPECT_EQ(desk.state(first), Refused);
    EXPECT_EQ(desk.state(second), Done);
    EXPECT_EQ(desk.document(), "start - color");
    EXPECT_FALSE(desk.queue().allChangesMade());
    EXPECT_TRUE(desk.queue().allChangesMade()) << "asked for anew";
}

TEST(LoadQueue, OnlyChangesCountAsChanges)
{
    Desk desk;
    const auto opening = desk.request(First::Document);
    desk.request(Second::Color);
    EXPECT_FALSE(desk.queue().changesPending()) << "it comes to another document";
    desk.queue().end(*opening, Refused);
    desk.queue().startNext();
    EXPECT_TRUE(desk.queue().changesPending());
    desk.finishAll();
    EXPECT_TRUE(desk.queue().allChangesMade());
    desk.request(First::Height);
    desk.request(Second::Height);
    desk.finishAll();
    EXPECT_TRUE(desk.queue().allChangesMade()) << "what was overtaken was not wanted";
    desk.request(First::MapsAsStep);
    desk.request(Second::Cancel);
    EXPECT_FALSE(desk.queue().allChangesMade());
}

// Also when what was given up is asked for by each change of the document.
TEST(LoadQueue, WhatWasFollowedToNoGoodEndIsNotFollowedAgain)
{
    for (const JobState how : {Refused, Cancelled}) {
        Desk desk;
        const auto first = desk.request(First::Follow);
        how == Refused ? void(desk.queue().end(*first, Refused)) : desk.queue().cancel();
        EXPECT_EQ(desk.state(desk.request(Second::Follow)), Pointless);
        desk.queue().followAgain();
        EXPECT_EQ(desk.state(desk.request(Second::Follow)), Running);
    }
    Desk desk;
    desk.request(First::Follow);
    desk.finishAll();
    EXPECT_EQ(desk.state(desk.request(Second::Follow)), Pointless) << "it would be done for ever";
    desk.request(Second::Fits);
    EXPECT_EQ(desk.state(desk.request(Second::Follow)), Running);
    desk.request(Second::Color);
    desk.finishAll();
    EXPECT_EQ(desk.state(desk.request(Second::Follow)), Running) << "it was put off, not given up";
}
