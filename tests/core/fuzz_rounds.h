// How long tests with damaged files go on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <cstdlib>
#include <random>

// `usual` rounds, or RELIEVO_FUZZ times as many (packaging/test dev sets it): the first ones stay the same.
inline int fuzzRounds(int usual)
{
    const char* times = std::getenv("RELIEVO_FUZZ");
    return usual * (times && std::atoi(times) > 1 ? std::atoi(times) : 1);
}

// The rounds of one test: `usual` ones, and on until RELIEVO_FUZZ_SECONDS have gone by. RELIEVO_FUZZ_SEED makes them others.
class FuzzLoop {
public:
    explicit FuzzLoop(int usual) : m_left(usual)
    {
        const char* seed = std::getenv("RELIEVO_FUZZ_SEED");
        random.seed(seed ? unsigned(std::strtoul(seed, nullptr, 10)) : 1u);
        const char* seconds = std::getenv("RELIEVO_FUZZ_SECONDS");
        m_end = Clock::now() + std::chrono::seconds(seconds ? std::atoi(seconds) : 0);
    }
    bool next()
    {
        if (m_left <= 0 && Clock::now() >= m_end)
            return false;
        --m_left;
        ++round;
        return true;
    }
    std::mt19937 random;
    int round = 0; // of failures: to come to it again

private:
    using Clock = std::chrono::steady_clock;
    int m_left;
    Clock::time_point m_end;
};
