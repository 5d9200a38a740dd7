// The shader files of the program as text, embedded at build time or read from a folder.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

namespace relievo {

struct ShaderFile {
    std::string_view name; // relative to shaders/, "techniques/relief.glsl"
    std::string_view text;
};
const std::vector<ShaderFile>& embeddedShaders();

} // namespace relievo
