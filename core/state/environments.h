// The built-in environments, by name; core/image/environment makes them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

// Made by formula; average radiance 1.
struct EnvironmentRow {
    std::string_view key;
    std::string_view label;
};
inline constexpr std::array<EnvironmentRow, 6> kEnvironments = {{{"studio", "Studio"}, {"overcast", "Overcast sky"},
    {"clear-sky", "Clear sky"}, {"sunset", "Sunset"}, {"night-interior", "Night interior"}, {"grey", "Even grey"}}};

// A name that is none of these is a file's.
constexpr bool isBuiltInEnvironment(std::string_view name)
{
    return std::ranges::count(kEnvironments, name, &EnvironmentRow::key) > 0;
}

} // namespace relievo
