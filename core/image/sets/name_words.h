// The words of texture names: which kinds of map they mean, and which say nothing about the kind.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/sets/file_names.h"
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

inline bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

struct Meaning {
    std::vector<MapRole> roles;
    Packing packing = Packing::None;
    int rank = 0;
    Convention convention = Convention::Unsure;
};

// All words are lower case. Calls visit(word, index) for each word of a list separated by spaces.
template <class Visit> void forEachWord(std::string_view list, Visit visit)
{
    int index = 0;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(' ', at), list.size());
        visit(list.substr(at, end - at), index++);
        at = end + 1;
    }
}
template <class Test> bool anyWord(std::string_view list, Test test)
{
    bool found = false;
    forEachWord(list, [&](std::string_view word, int) { found = found || test(word); });
    return found;
}
bool listed(std::string_view list, std::string_view word);
bool allDigits(std::string_view text); // false for ""

// What a word means; null for none. With or without "map", "texture" or "tex" at its end.
const Meaning* lookUp(const std::string& word);

// "normheight", "alb" + "ht": a colour or normal, then a scalar map in its alpha.
std::optional<Meaning> pairOf(const std::string& first, const std::string& second);
std::optional<Meaning> pairInWord(const std::string& word);

// 1k, 4096, 1024x1024, 512px: how many texels it has.
bool isResolution(std::string_view word);
// A resolution, or 16bit, u16, 32f, png: how the image is stored, not what it shows.
bool isTag(std::string_view word);
// v2, ver03, var1: one of several takes.
bool isVersion(std::string_view word);
// Says nothing about the kind, at the end of a name.
bool isNoise(std::string_view word);

} // namespace relievo
