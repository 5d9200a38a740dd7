// The texts of the program's own targets (resources/exports), embedded at build time.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

namespace relievo {

struct EmbeddedTarget {
    std::string_view name; // "godot4.tpl"
    std::string_view text;
};
const std::vector<EmbeddedTarget>& embeddedTargets();

} // namespace relievo
