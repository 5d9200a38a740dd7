// Several files at once: two helpers, what is there first, and that nothing is read or copied twice.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/process_client.h"
#include "core/image/material.h"
#include "core/image/sets/texture_set.h"
#include "tests/core/image/image_support.h"
#include <atomic>
#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>

using namespace relievo;
using namespace relievo::test;
using oneapi::tbb::global_control;

namespace {
// Threads for as long as it lives, however many cores there are.
struct Threads : global_control {
    explicit Threads(std::size_t count) : global_control(max_allowed_parallelism, count) { }
};

std::vector<int> children()
{
    std::istringstream list(readAll("/proc/self/task/" + std::to_string(::getpid()) + "/children"));
    return {std::istream_iterator<int>(list), {}};
}

void endHelpers()
{
    for (const int id : children()) {
        ::kill(id, SIGKILL);
        siginfo_t end;
        ::waitid(P_PID, id_t(id), &end, WEXITED | WNOWAIT);
    }
}

// Two requests, of which one is answered while the first helper stands still, and the other when it goes on.
void readBeside(const TemporaryFolder& folder)
{
    ASSERT_TRUE(writeImage(folder / "x.png", noiseImage(8, 8, 1, PixelType::U8)));
    const int first = imageHelperId();
    ASSERT_EQ(::kill(first, SIGSTOP), 0);
    std::atomic<int> good = 0;
    std::vector<std::jthread> threads;
    for (int i = 0; i < 2; ++i)
        threads.emplace_back([&] { good += readImage(folder / "x.png").has_value(); });
    for (int i = 0; i < 1000 && good < 1; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(good, 1);
    ::kill(first, SIGCONT);
    threads.clear();
    EXPECT_EQ(good, 2);
    EXPECT_EQ(imageHelperId(), first);
}

// Height, colour, normals and roughness of one material.
void writeSet(const TemporaryFolder& folder)
{
    ASSERT_TRUE(writeImage(folder / "rock_height.png", hillHeights(64, PixelType::U16)));
    ASSERT_TRUE(writeImage(folder / "rock_normal.png", hillNormals(64, true)));
    ASSERT_TRUE(writeImage(folder / "rock_color.png", noiseImage(64, 64, 3, PixelType::U8)));
    ASSERT_TRUE(writeImage(folder / "rock_roughness.png", noiseImage(64, 64, 1, PixelType::U8)));
}
} // namespace

// A helper that was collected is no zombie, and its time counts as this process's.
TEST(SideBySide, AKilledHelperIsCollected)
{
    HelperProcess helper;
    bool isFresh = false;
    ASSERT_TRUE(helper.ensureRunning(isFresh));
    const int id = helper.id();
    ASSERT_EQ(::kill(id, 0), 0);
    helper.kill();
    EXPECT_EQ(::kill(id, 0), -1) << "a zombie takes signals still";
}

// The first helper stands still: a second one answers.
TEST(SideBySide, TwoRequestsAreAnsweredAtOnce)
{
    const Threads two(2);
    const TemporaryFolder folder;
    readBeside(folder);
}

#ifndef __SANITIZE_ADDRESS__ // there each is started by itself
TEST(SideBySide, BothHelpersComeOfOneStart)
{
    const Threads two(2);
    const TemporaryFolder folder;
    const char* set = std::getenv("RELIEVO_IMAGEIO");
    const std::string helper = set ? set : RELIEVO_BIN "/relievo-imageio";
    writeAll(folder / "helper", "#!/bin/sh\necho >> \"$0.runs\"\nexec \"" + helper + "\" \"$@\"\n");
    std::filesystem::permissions(folder / "helper", std::filesystem::perms::owner_all);
    ::setenv("RELIEVO_IMAGEIO", (folder / "helper").c_str(), 1);
    endHelpers();
    readBeside(folder);
    ::setenv("RELIEVO_IMAGEIO", helper.c_str(), 1);
    EXPECT_EQ(readAll(folder / "helper.runs"), "\n");
}
#endif

TEST(SideBySide, ThereAreNoMoreHelpersThanThreads)
{
    EXPECT_EQ((Threads(1), imageHelperCount()), 1u);
    EXPECT_EQ((Threads(2), imageHelperCount()), 2u);
    EXPECT_EQ((Threads(16), imageHelperCount()), 2u);
}

TEST(SideBySide, HelpersThatDieAreReplaced)
{
    const Threads two(2);
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "x.png", noiseImage(8, 8, 1, PixelType::U8)));
    for (int round = 0; round < 3; ++round) {
        endHelpers();
        std::atomic<int> good = 0;
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] { good += readImage(folder / "x.png").has_value(); });
        threads.clear();
        EXPECT_EQ(good, 4) << round;
    }
}

// One after the other: each early set holds one map more, and its pixels are those of the whole set.
TEST(SideBySide, HeightsAreToldFirstAndThenTheRest)
{
    const Threads one(1);
    const TemporaryFolder folder;
    writeSet(folder);
    std::vector<TextureSet> told;
    const auto set = openTextureSet(folder.path(), {}, [&](const TextureSet& part) { told.push_back(part); });
    ASSERT_TRUE(set) << message(set.error());
    ASSERT_EQ(set->maps.size(), 4u);
    EXPECT_TRUE(set->coming.empty());
    ASSERT_EQ(told.size(), 3u);
    for (std::size_t i = 0; i < told.size(); ++i) {
        ASSERT_EQ(told[i].maps.size(), i + 1);
        for (std::size_t at = 0; at < set->maps.size(); ++at) {
            const FoundMap& whole = set->maps[at];
            EXPECT_NE(told[i].coming.contains(whole.kind), at <= i);
            if (at <= i) {
                EXPECT_EQ(told[i].slots()[std::size_t(whole.kind)], set->slots()[std::size_t(whole.kind)]);
                EXPECT_EQ(told[i].images.at(whole.file), set->images.at(whole.file)) << "read twice";
            }
        }
    }
}

TEST(SideBySide, ABrokenMapIsNotWaitedFor)
{
    const Threads one(1);
    const TemporaryFolder folder;
    writeSet(folder);
    writeAll(folder / "rock_height.png", readAll(folder / "rock_height.png").substr(0, 200));
    std::vector<TextureSet> told;
    const auto set = openTextureSet(folder.path(), {}, [&](const TextureSet& part) { told.push_back(part); });
    ASSERT_TRUE(set);
    EXPECT_EQ(set->maps.size(), 3u);
    EXPECT_EQ(told.size(), 2u);
}

TEST(SideBySide, MapsThatAreAsTheirFileIsAreNotCopied)
{
    const TemporaryFolder folder;
    writeSet(folder);
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set);
    const auto material = loadMaterial(set->slots(), set->images);
    ASSERT_TRUE(material);
    for (const MapKind kind : {MapKind::Color, MapKind::Roughness})
        EXPECT_EQ(material->map(kind), &set->images.at(set->slots()[std::size_t(kind)].file)->image);
}
