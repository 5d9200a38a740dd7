// The decoded maps of a material, ready for the renderer, the tracer and the exporters.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/image/sets/texture_set.h"
#include "core/state/map_slots.h"
#include <array>
#include <memory>
#include <optional>

namespace relievo {

// Immutable. A map that the slots do not name is absent: nothing is made up here.
struct Material {
    std::optional<HeightField> height; // 1 = top, already flipped when the slot says invert; wrap repeat
    // One image per kind but Height, row(kind).channels wide, conventions applied: normals OpenGL style (stored as n * 0.5 + 0.5),
    // inverted where the slot says so, gloss NOT folded into roughness. Colour: integer types stay sRGB encoded, F32 is linear.
    std::array<std::shared_ptr<const Image>, kMapKindCount> maps;
    MapSlots slots; // what this was loaded from
    Warnings warnings; // "height-range": mapped from min..max; "nan-repaired": how many texels; "map-missing": file is gone ...

    const Image* map(MapKind kind) const { return maps[std::size_t(kind)].get(); }
};

// Loads every non-empty slot. A slot whose file is missing or broken becomes a warning and stays empty ("map-missing", "map-broken"),
// the rest is kept; it is an error only when nothing at all could be read. `decoded` (from openTextureSet) spares a second decode.
// `previous`: maps whose slot did not change are taken over from it. "sample:KEY[@SIZE]" is made by formula (samples.h).
// Cancelled: an error of that code.
Expected<Material> loadMaterial(
    const MapSlots& slots, const DecodedImages& decoded = {}, const Material* previous = nullptr, const Progress& progress = {});

// What is told of a slot that reads the alpha of a picture without alpha: the map is left out.
Warning channelMissing(MapKind kind, const MapSlot& slot);

} // namespace relievo
