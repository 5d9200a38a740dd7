// What went wrong, in words for the user: every border of the program returns a value or one of these.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace relievo {

// What kind of failure it is, for code that has to decide; texts are for people only.
enum class ErrorCode {
    Refused, // the request or the input cannot be used as it is
    NotFound, // there is no file, row or part of that name
    Unreadable, // the file is there and cannot be read: damaged, of another kind, no permission
    NotWritable, // the output cannot be written
    NoSpace, // because the disk is full
    NoMemory,
    NotReady, // what it needs is still being made
    Driver, // OpenGL lacks what is needed, or a shader does not compile
    Cancelled, // on request: nothing is wrong
};

// Printed as "relievo: error: WHERE: WHAT. HINT". No full stops inside the parts.
struct Error {
    std::string what; // one clause: "the PNG data ends too early"
    std::string where; // file, key or option it is about
    std::string hint = {}; // the cure, may be empty
    ErrorCode code = ErrorCode::Refused;
    bool operator==(const Error&) const = default;
};

template <class T> using Expected = tl::expected<T, Error>;
inline tl::unexpected<Error> failure(ErrorCode code, std::string where, std::string what, std::string hint = {})
{
    return tl::unexpected<Error>(Error{std::move(what), std::move(where), std::move(hint), code});
}
inline tl::unexpected<Error> failure(std::string where, std::string what, std::string hint = {})
{
    return failure(ErrorCode::Refused, std::move(where), std::move(what), std::move(hint));
}
inline tl::unexpected<Error> cancelled(std::string where)
{
    return failure(ErrorCode::Cancelled, std::move(where), "cancelled");
}
inline bool isCancelled(const Error& error)
{
    return error.code == ErrorCode::Cancelled;
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
