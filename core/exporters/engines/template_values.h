// What the templates of targets may name, and filling them in.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/packing.h"
#include <map>
#include <string>

namespace relievo {

using Words = std::map<std::string, std::string>;

struct TemplateValues {
    Words words; // {{depthMetres}}: numbers with a point where they are no counts
    std::map<std::string, bool> switches; // {{#repeat}} ... {{/repeat}}
    std::map<std::string, Words> textures; // {{#height}}{{height.file}}{{/height}}; without words: not written
};

// The engine's number for the material's depth, and how wrong it has to be.
struct EngineDepth {
    float metres = 0.f; // of the written heights, black to white
    float tiles = 0.f; // the same, in tiles
    float number = 0.f; // what the engine is given
    float drawn = 1.f; // share of the depth that the number stands for, where the engine's limits cut it
};
EngineDepth engineDepth(const EngineFacts& engine, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

// All but the textures. The names are listed in the manual's chapter "Targets of your own" (tested).
TemplateValues valuesOf(const ExportRow& row, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

// The template filled in; {{x}} has quotes, backslashes and control characters escaped by backslashes, {{{x}}} not. `more`: names beside
// the values. A name that there is not, or a tag that is not closed: an error with `where` and the line, of which the first is `line`.
Expected<std::string> filled(const std::string& text, const TemplateValues& values, const Words& more, const std::string& where, int line);

} // namespace relievo
