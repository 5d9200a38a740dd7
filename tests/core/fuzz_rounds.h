// How long tests with damaged files go on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdlib>

// `usual` rounds, or RELIEVO_FUZZ times as many (packaging/test dev sets it): the first ones stay the same.
inline int fuzzRounds(int usual)
{
    const char* times = std::getenv("RELIEVO_FUZZ");
    return usual * (times && std::atoi(times) > 1 ? std::atoi(times) : 1);
}
