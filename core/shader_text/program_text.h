// Assembly of shader programs as text: includes, generated uniforms and map functions, only what a State uses.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/map_slots.h"
#include "core/state/parameters.h"
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

struct Material;
struct TechniqueRow;
struct ViewRow;

// GLSL 4.10, or ES 3.00 as WebGL2 has it.
enum class Dialect { Desktop, Es };

// What a program is made of. Equal features give equal text: usable as a cache key.
struct ProgramFeatures {
    std::string technique = "relief"; // key of kTechniques
    std::string view = "shaded"; // key of kViews
    EnumSet<MapKind> maps; // maps that the material has
    bool shadows = false; // self-shadows wanted (a technique that does not search has none)
    bool softShadows = false; // and by a light with a size
    bool horizonShadows = false; // found by the map of horizons
    bool severalLights = false; // or one that is not directional, where light is computed
    bool linear = false; // Target::linear
    bool glows = false; // the light itself is written too, for the glow (render/glow.h)
    bool coarser = false; // an exact technique reads mip levels
    bool curved = false; // silhouettes
    bool prisms = false; // and by the mesh itself, which the renderer has to provide
    bool borders = false; // of a mesh that has some
    bool posed = false; // the mesh deforms
    bool objectShadows = false; // the parameter, where light is computed
    bool onMesh = false; // the error view compares with the displaced mesh (ExactDistances)
    bool clamps = false; // an exact search ends at the tile's borders
    bool exported = false; // for other programs to run: see exportedFeatures
    bool planes = false; // exported for the loaders of engines: pictures of 8 bits, see exportedForLoaders
    bool panorama = false; // exported with the environment as the renderer has it, instead of light by formula
    Dialect dialect = Dialect::Desktop; // of what is exported
    std::array<std::uint8_t, kParameters.size()> variants = {}; // which of its shader files each parameter chooses (ParameterRow::shader)
    auto operator<=>(const ProgramFeatures&) const = default;

    std::size_t variant(const Member& member) const { return variants[indexOf(member)]; }
    void setVariant(const Member& member, std::size_t variant) { variants[indexOf(member)] = std::uint8_t(variant); }
};
// Those that the material has, heights among them.
EnumSet<MapKind> presentMaps(const Material& material);

// The features of a pane as drawn: only maps that the view reads stand in it through the text, not here.
ProgramFeatures programFeatures(
    const Parameters& parameters, const TechniqueRow& technique, const ViewRow& view, EnumSet<MapKind> maps, bool linear);

inline constexpr std::string_view kLightsLeftOut
    = "What is written is lit by the first light, as a directional one: the other lights, and places of lights, are left out.";

// The same for a shader that others run: with a frame that needs no vertex attributes but position, normal and uv, light from the
// surroundings by formula, no mip levels of the heights, and nothing that only this renderer can provide (bent rays, shadows between
// objects, a vignette, a glow). In ES heights are read texel by texel: WebGL2 does not filter them.
ProgramFeatures exportedFeatures(const Parameters& parameters, const TechniqueRow& technique, EnumSet<MapKind> maps, Dialect dialect);
// The same in ES for an engine's own loader of pictures, which keeps 8 bits: heights and acceleration map are split into upper and lower
// bytes (heightMap in red and green; boundHighMap, boundLowMap), occlusion, roughness and metallic lie in ormMap, opacity in the alpha of
// colorMap. The polygon's depth is kept.
ProgramFeatures exportedForLoaders(const Parameters& parameters, const TechniqueRow& technique, EnumSet<MapKind> maps);
// Stand before and after what the search needs, in a fragment shader that is exported.
inline constexpr std::string_view kTechniqueBegins = "// >>> technique", kTechniqueEnds = "// <<< technique";

// Reads a shader file by its name under shaders/.
using ShaderReader = std::function<Expected<std::string>(std::string_view name)>;

// `trace` and what it needs, undeclared textures and parameters left to the caller: exact searches read heights and codes from pictures
// of 8 bits (heights/corners_planes.glsl), others filter. Errors: techniques without shader, or with a volume.
Expected<std::string> searchForGodot(const TechniqueRow& technique, bool clamps, const ShaderReader& read);

// A fragment shader of GLSL 4.10 whose `trace` Unreal can run once it is translated: heights as a texture of one channel, the acceleration
// map as exportedForLoaders has it. Errors: as searchForGodot.
Expected<std::string> searchForUnreal(const TechniqueRow& technique, bool clamps, const ShaderReader& read);

struct ShaderText {
    std::string text;
    std::vector<std::string> files; // file i of "#line n i"; file 0 is generated text
    bool mentions(std::string_view identifier) const;
};
struct ProgramText {
    ShaderText vertex, fragment;
};

ShaderReader embeddedReader();
ShaderReader folderReader(const std::filesystem::path& folder); // falls back to the embedded text of a file that is not there

// The programs of the renderer, GLSL 4.10.
Expected<ProgramText> meshProgram(const ProgramFeatures& features, const ShaderReader& read);
// features: how colours are shown (linear, dialect, and the variants of the display).
Expected<ProgramText> backgroundProgram(Backdrop behind, const ProgramFeatures& features, const ShaderReader& read);
Expected<ProgramText> groundProgram(bool linear, const ShaderReader& read); // the floor under the mesh
Expected<ProgramText> wireframeProgram(bool posed, const ShaderReader& read);
Expected<ProgramText> composeProgram(const ShaderReader& read); // two pictures in one place (render/compose.h)
// The steps of the glow (render/glow.h): what glows, pictures of it at half or twice the size, and the picture with it.
enum class GlowStep { Excess, Resized, Glowing };
Expected<ProgramText> glowProgram(GlowStep step, const ProgramFeatures& features, const ShaderReader& read);
// Runs the technique's search on rays in textures (`trace --device gl`).
Expected<ProgramText> traceProgram(std::string_view technique, const ShaderReader& read, Dialect dialect = Dialect::Desktop);
// The same on prisms of a mesh (shaders/view_ray/trace_prisms.glsl); the technique has to search.
Expected<ProgramText> prismProgram(std::string_view technique, const ShaderReader& read, Dialect dialect = Dialect::Desktop);

// A driver's log with "0:12(3)" or "1:12:" turned into "relief.glsl:12".
std::string namedLog(const std::string& log, const ShaderText& text);

// The uniform and sampler declarations that `text` (without comments) needs, from the tables.
std::string uniformDeclarations(const std::string& text);

// Same length, comments blanked: for searching identifiers and for the driver.
std::string withoutComments(std::string_view text);
bool mentionsIdentifier(std::string_view text, std::string_view identifier);

} // namespace relievo
