// Shader text as values of templates: the technique of the State for other programs to run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/template_values.h"

namespace relievo {

// Adds those of the words that `text` mentions: vertex410, fragment410, vertexEs300, fragmentEs300 (complete shaders of GLSL 4.10 and
// ES 3.00, each uniform with the value that this State gives it), vertexHlsl, fragmentHlsl, vertexMsl, fragmentMsl (the same, translated),
// searchGodot (what `trace` needs, in Godot's shading language); fragmentLoaders and uniformsLoaders, with the switch ownShader, for the
// loaders of web engines (exportedForLoaders): ES 3.00 without its #version, and the uniforms as JavaScript, {name: [type, value]};
// searchUnreal, with the same switch: searchAsStruct of the technique, its parameters written in.
// Errors: a technique that has no shader; but of ownShader, which is off then.
Expected<void> addShaders(
    TemplateValues& values, const std::string& text, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

// Why a target that offers the technique beside the engine's own material has to leave it out; "" where it does not.
std::string techniqueLeftOut(const TargetText& target, const ExportJob& job);

} // namespace relievo
