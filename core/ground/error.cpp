// Errors as sentences.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/error.h"

namespace relievo {

std::string message(const Error& error)
{
    std::string text = error.where.empty() ? error.what : error.where + ": " + error.what;
    text += '.';
    if (!error.hint.empty())
        text += ' ' + error.hint + '.';
    return text;
}

} // namespace relievo
