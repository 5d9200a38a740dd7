// A stage of an exported program in the shading languages of Direct3D and Metal.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <string>

namespace relievo {

enum class Stage { Vertex, Fragment };
enum class ShadingLanguage { Hlsl, Msl }; // HLSL of shader model 5.0, MSL 1.2

// `glsl` (GLSL 4.10) by way of SPIR-V. Names are kept; uniforms become members of one buffer `Relief` and are read as u_NAME (HLSL) or
// u.NAME (MSL); a texture's sampler is called NAMESampler. The entry point is `main` (HLSL), `relief_vertex` or `relief_fragment` (MSL).
// What `trace` needs, if there is such a function, stands between kTechniqueBegins and kTechniqueEnds. Errors: a text that does not
// compile.
Expected<std::string> translated(const std::string& glsl, Stage stage, ShadingLanguage language);

// `trace` of a fragment shader as HLSL for a place inside of a function, as Unreal's Custom node is one: structs, then `Relief relief;`
// whose members are the functions, with its textures and samplers (NAME, NAMESampler) set from variables of these names. Errors: as above,
// or uniforms.
Expected<std::string> searchAsStruct(const std::string& glsl);

} // namespace relievo
