// Errors as sentences.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/error.h"
#include "core/ground/shown_text.h"

namespace relievo {

std::string message(const Error& error)
{
    std::string text = error.where.empty() ? shownText(error.what) : shownText(error.where) + ": " + shownText(error.what);
    text += '.';
    if (!error.hint.empty())
        text += ' ' + shownText(error.hint) + '.';
    return text;
}

} // namespace relievo
