// Names of built-in materials, as SOURCE and map slots hold them: "sample:bricks", "sample:bricks@512".
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace relievo {

// No file of that name is looked for.
constexpr bool namesSample(std::string_view name)
{
    return name.starts_with("sample:");
}

} // namespace relievo
