// Numbers of glTF's material extensions that lie over the metallic-roughness model, and the parameters that they are.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <array>

namespace relievo {

struct GltfLayerRow {
    const char* extension;
    const char* factor; // a member of it
    float Parameters::*member;
    float without; // value where the extension or the member is missing
    bool decides = false; // the extension has no effect where this is `without`
};
// Those of one extension stand together. The color of the sheen is the product of two parameters and stands in no row.
inline constexpr auto kGltfLayers = std::to_array<GltfLayerRow>({
    {"KHR_materials_clearcoat", "clearcoatFactor", &Parameters::clearcoat, 0.f, true},
    {"KHR_materials_clearcoat", "clearcoatRoughnessFactor", &Parameters::clearcoatRoughness, 0.f},
    {"KHR_materials_transmission", "transmissionFactor", &Parameters::transmission, 0.f, true},
    {"KHR_materials_ior", "ior", &Parameters::ior, 1.5f, true},
    {"KHR_materials_sheen", "sheenRoughnessFactor", &Parameters::sheenRoughness, 0.f},
});
inline constexpr const char* kSheenExtension = "KHR_materials_sheen";
inline constexpr const char* kSheenColor = "sheenColorFactor";

} // namespace relievo
