// Shader text as values of templates: the technique of the State for other programs to run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/template_values.h"

namespace relievo {

// Adds those of the words that `text` mentions: vertex410, fragment410, vertexEs300, fragmentEs300 (complete shaders of GLSL 4.10 and
// ES 3.00, each uniform with the value that this State gives it), searchGodot (what `trace` needs, in Godot's shading language).
// Errors: a technique that has no shader.
Expected<void> addShaders(
    TemplateValues& values, const std::string& text, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

} // namespace relievo
