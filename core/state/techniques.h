// The table of search techniques: one row and one shader file each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/technique_row.h"
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

inline constexpr auto kTechniques = std::to_array<TechniqueRow>({
    {.key = "flat",
        .label = "Flat",
        .file = "techniques/flat.glsl",
        .paper = "-",
        .readsNormals = false,
        .help = "No relief: colour and roughness on the smooth mesh."},
    {.key = "bump",
        .label = "Bump",
        .file = "techniques/bump.glsl",
        .paper = "Blinn 1978, Simulation of Wrinkled Surfaces",
        .help
        = "Normals only: light reacts to the relief, the picture does not move. The normal map, or normals made from the height map."},
    {.key = "parallax",
        .label = "Parallax",
        .file = "techniques/parallax.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::offsetLimiting, &Parameters::heightMips},
        .paper = "Kaneko et al. 2001, Detailed Shape Representation with Parallax Mapping; Welsh 2004 (offset limiting)",
        .displaces = true,
        .help = "One step along the view by the height under the surface point: cheap, right only for gentle slopes."},
    {.key = "steep",
        .label = "Steep parallax",
        .file = "techniques/steep.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "McGuire and McGuire 2005, Steep Parallax Mapping",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search; the first sample inside is the answer, so it shows steps."},
    {.key = "pom",
        .label = "Parallax occlusion",
        .file = "techniques/pom.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Tatarchuk 2006, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search, then one secant step: what most engines call parallax occlusion mapping."},
    {.key = "interval",
        .label = "Interval",
        .file = "techniques/interval.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::refineSteps, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Risser, Shah, Pattanaik 2007, Faster Relief Mapping Using the Secant Method",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search, then secant steps, which close in faster than halvings where the surface is smooth."},
    {.key = "relief",
        .label = "Relief",
        .file = "techniques/relief.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::refineSteps, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3",
        .displaces = true,
        .searches = true,
        .help = "Linear search whose step count follows the viewing angle, then bisection of the step that went inside."},
    {.key = "relief-fixed",
        .label = "Relief, fixed steps",
        .file = "techniques/relief-fixed.glsl",
        .maps = {MapKind::Height},
        .parameters
        = {&Parameters::doublePrecision, &Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo 2004, Relief Mapping in a Pixel Shader using Binary Search",
        .displaces = true,
        .searches = true,
        .help = "The first relief mapping: 10 linear steps and 6 halvings whatever the view, or 20 and 5."},
    {.key = "contact",
        .label = "Contact refinement",
        .file = "techniques/contact.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Riccardi 2019, Contact Refinement Parallax Mapping",
        .displaces = true,
        .searches = true,
        .help
        = "Linear search, then the step that went inside is searched again in as many small steps: no halvings, no miss within that step."},
    {.key = "sphere",
        .label = "Sphere tracing",
        .file = "techniques/sphere.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "distance",
        .parameters = {&Parameters::leapSteps, &Parameters::safeBalls, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Donnelly 2005, Per-Pixel Displacement Mapping with Distance Functions (GPU Gems 2, chapter 8)",
        .displaces = true,
        .searches = true,
        .help = "Leaps by a volume of distances: much memory, and thin relief is blurred by the volume's size."},
    {.key = "cone",
        .label = "Cone stepping",
        .file = "techniques/cone.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Dummer 2006, Cone Step Mapping",
        .displaces = true,
        .searches = true,
        .help = "Leaps by a map of empty cones. The cones know texels only: between them a leap may end inside."},
    {.key = "cone-quad",
        .label = "Quad cones",
        .file = "techniques/cone-quad.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-quad",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18)",
        .displaces = true,
        .searches = true,
        .help = "Cone stepping with a cone for each of four directions: wider leaps for two fetches a step."},
    {.key = "cone-relaxed",
        .label = "Relaxed cones",
        .file = "techniques/cone-relaxed.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-relaxed",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::lastBracket, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18), listing 18-3",
        .displaces = true,
        .searches = true,
        .help = "Wider cones that a ray may enter the relief in, then bisection: the favourite of relief mapping in games."},
    {.key = "cone-robust",
        .label = "Robust cones",
        .file = "techniques/cone-robust.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-robust",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::provenStep, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Ban, Valasek, Balint, Vad 2024, Robust Cone Step Mapping",
        .displaces = true,
        .searches = true,
        .help = "Relaxed cones made safe for bilinear heights, nearly: never less than a step to the cell's border."},
    {.key = "pyramid",
        .label = "Maximum pyramid",
        .file = "techniques/pyramid.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "pyramid",
        .parameters = {&Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows},
        .paper = "Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "Exact: down a pyramid of maxima to the cell, which is solved in closed form."},
    {.key = "cell-cone",
        .label = "Cell cones",
        .file = "techniques/cell-cone.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cell-cone",
        .parameters = {&Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows},
        .paper = "This program's own: cones and boxes over the bilinear cells, with proof",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "Exact, with fewer fetches than the pyramid: leaps by boxes and cones of four nested nodes, cells solved in closed form."},
    {.key = "as-godot4",
        .label = "As Godot 4",
        .file = "techniques/as-godot4.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps},
        .paper = "Godot 4.6, StandardMaterial3D with deep parallax; compared with the engine",
        .help
        = "Layers and one interpolation, not divided by V.z: the depth drawn shrinks with the cosine of the angle. White lies on the mesh. "
          "With mipmaps on the height map Godot adds jumps at outlines of the relief (0.005 of UV for a pixel in a hundred, 0.6 at worst).",
        .engine = "Godot 4"},
    {.key = "as-godot4-simple",
        .label = "As Godot 4, simple",
        .file = "techniques/as-godot4-simple.glsl",
        .maps = {MapKind::Height},
        .paper = "Godot 4.6, StandardMaterial3D without deep parallax; compared with the engine",
        .help
        = "One step by the height under the point, not divided by V.z. White lies on the mesh. With mipmaps Godot reads blurred heights "
          "where the texture is far.",
        .engine = "Godot 4 without deep parallax"},
    {.key = "as-godot3",
        .label = "As Godot 3",
        .file = "techniques/as-godot3.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps},
        .paper = "Godot 3.2.3, SpatialMaterial with deep parallax; its shader text",
        .help
        = "The formula of Godot 4's deep parallax; the depth texture is the height map turned over. Mipmaps add what they add in Godot 4.",
        .engine = "Godot 3"},
    {.key = "as-unity-urp",
        .label = "As Unity URP",
        .file = "techniques/as-unity-urp.glsl",
        .maps = {MapKind::Height},
        .paper = "Unity Universal Render Pipeline, Lit (ParallaxOffset1Step); by its published formula",
        .help = "One step by the height under the point, divided by V.z + 0.42. Mid-grey lies on the mesh; depths are held within 0.005 "
                "and 0.08 of "
                "the tile. With mipmaps Unity reads blurred heights where the texture is far.",
        .engine = "Unity URP",
        .zero = 0.5f},
    {.key = "as-unity-builtin",
        .label = "As Unity built-in",
        .file = "techniques/as-unity-builtin.glsl",
        .maps = {MapKind::Height},
        .paper = "Unity built-in pipeline, Standard (ParallaxOffset1Step); by its published formula",
        .help = "The formula of Unity URP: one step, mid-grey on the mesh, depths held within 0.005 and 0.08 of the tile. With mipmaps "
                "Unity reads "
                "blurred heights where the texture is far.",
        .engine = "Unity's built-in pipeline",
        .zero = 0.5f},
    {.key = "as-unity-hdrp",
        .label = "As Unity HDRP",
        .file = "techniques/as-unity-hdrp.glsl",
        .maps = {MapKind::Height},
        .paper = "Unity High Definition Render Pipeline, Lit with pixel displacement (PerPixelDisplacement); by its published formula",
        .help = "5 to 15 layers, by the slope of the ray in the texture, then up to three secant steps, right to 0.01 of the depth. White "
                "lies on "
                "the mesh. Unity fades the relief out where it is far (Fading Mip Level Start).",
        .engine = "Unity HDRP"},
    {.key = "as-unreal",
        .label = "As Unreal",
        .file = "techniques/as-unreal.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps},
        .paper = "Unreal material function ParallaxOcclusionMapping; by its published formula",
        .displaces = true,
        .help
        = "Layers and one interpolation, divided by V.z. The Reference Plane is the midlevel. Unreal reads coarser mip levels where the "
          "texture is far, chosen before the search.",
        .engine = "Unreal"},
    {.key = "as-o3de",
        .label = "As O3DE",
        .file = "techniques/as-o3de.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::maxSteps},
        .paper = "O3DE Standard PBR, parallax algorithm POM (AdvancedParallaxMapping); by its published formula",
        .help = "16, 32, 64 or 128 layers whatever the angle (the quality that is not below the most steps) and one interpolation. White "
                "lies on the "
                "mesh (offset 0). O3DE reads coarser mip levels where the texture is far, chosen before the search.",
        .engine = "O3DE"},
    {.key = "as-bevy",
        .label = "As Bevy",
        .file = "techniques/as-bevy.glsl",
        .maps = {MapKind::Height},
        .paper = "Bevy, ParallaxMappingMethod::Occlusion, 16 layers; by its published formula",
        .help = "1 layer seen from straight above to 16 at grazing views, and one interpolation. White lies on the mesh. Bevy reads the "
                "finest mip "
                "level, as here.",
        .engine = "Bevy"},
    {.key = "as-babylon",
        .label = "As Babylon",
        .file = "techniques/as-babylon.glsl",
        .maps = {MapKind::Height},
        .paper = "Babylon 9.35, parallax occlusion; compared with the engine",
        .help = "15 layers of more than 15 that the depth has: the deepest part is cut off flat, at 0.58 of the depth seen from straight "
                "above, at "
                "0.80 at 70 degrees. White lies on the mesh. With mipmaps Babylon errs at outlines of the relief (0.004 of UV for a "
                "pixel in a "
                "hundred at 70 degrees).",
        .engine = "Babylon"},
    {.key = "as-playcanvas",
        .label = "As PlayCanvas",
        .file = "techniques/as-playcanvas.glsl",
        .maps = {MapKind::Height},
        .paper = "PlayCanvas 2.23 (from 2.22 on), parallax occlusion with 16 samples; compared with the engine",
        .help = "Layers of two texels, 16 at most, then five halvings; slopes over 5 are cut, and relief of less than three texels' way "
                "fades out. "
                "White lies on the mesh (heightMapBase 1). PlayCanvas reads coarser mip levels where the texture is far, with fewer layers "
                "there.",
        .engine = "PlayCanvas"},
    {.key = "reference",
        .label = "Reference",
        .maps = {MapKind::Height},
        .paper = "Exact: ray against each bilinear cell in turn, double precision",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "The exact answer that all others are measured against. CPU only."},
});

const TechniqueRow* findTechnique(std::string_view key); // nullptr when unknown

// Whether the technique takes part where none is named: all that a shader draws, but for engines'.
constexpr bool isChoice(const TechniqueRow& technique)
{
    return !technique.file.empty() && !technique.isEngine();
}

// The row of a key that the program itself names; a key that is none does not compile.
consteval const TechniqueRow& knownTechnique(std::string_view key)
{
    return *std::ranges::find(kTechniques, key, &TechniqueRow::key);
}

// Whether the technique lists the row, and it changes what a ray at full resolution finds.
constexpr bool searchesBy(const TechniqueRow& technique, const ParameterRow& row)
{
    return row.affects.contains(Affects::Search) && technique.parameters.contains(row);
}

} // namespace relievo
