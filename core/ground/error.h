// What went wrong, in words for the user: every border of the program returns a value or one of these.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace relievo {

// Printed as "relievo: error: WHERE: WHAT. HINT". No full stops inside the parts.
struct Error {
    std::string what; // one clause: "the PNG data ends too early"
    std::string where; // file, key or option it is about
    std::string hint; // the cure, may be empty
    bool operator==(const Error&) const = default;
};

template <class T> using Expected = tl::expected<T, Error>;
inline tl::unexpected<Error> failure(std::string where, std::string what, std::string hint = {})
{
    return tl::unexpected<Error>(Error{std::move(what), std::move(where), std::move(hint)});
}

// "WHERE: WHAT. HINT"
std::string message(const Error& error);

// Something the user should know although the work went on. `code` is stable for scripts ("normal-contradicts-height").
struct Warning {
    std::string code;
    std::string text;
    bool operator==(const Warning&) const = default;
};
using Warnings = std::vector<Warning>;

} // namespace relievo
