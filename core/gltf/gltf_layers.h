// Numbers of glTF's material extensions that lie over the metallic-roughness model, and the parameters that they are.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <array>
#include <numbers>

namespace relievo {

struct GltfLayerRow {
    const char* extension;
    const char* factor; // a member of it
    float Parameters::*member;
    float without; // value where the extension or the member is missing
    bool decides = false; // the extension has no effect where this is `without`
    float unit = 1.f; // what a unit of the parameter is in the file
};
// Those of one extension stand together. In a file the rotation starts at the mesh's tangent, here at the texture's u. The color of the
// sheen is the product of two parameters and stands in no row.
inline constexpr auto kGltfLayers = std::to_array<GltfLayerRow>({
    {"KHR_materials_clearcoat", "clearcoatFactor", &Parameters::clearcoat, 0.f, true},
    {"KHR_materials_clearcoat", "clearcoatRoughnessFactor", &Parameters::clearcoatRoughness, 0.f},
    {"KHR_materials_transmission", "transmissionFactor", &Parameters::transmission, 0.f, true},
    {"KHR_materials_ior", "ior", &Parameters::ior, 1.5f, true},
    {"KHR_materials_anisotropy", "anisotropyStrength", &Parameters::anisotropyStrength, 0.f, true},
    {"KHR_materials_anisotropy", "anisotropyRotation", &Parameters::anisotropyRotation, 0.f, false, std::numbers::pi_v<float> / 180.f},
    {"KHR_materials_sheen", "sheenRoughnessFactor", &Parameters::sheenRoughness, 0.f},
});
inline constexpr const char* kSheenExtension = "KHR_materials_sheen";
inline constexpr const char* kSheenColor = "sheenColorFactor";

} // namespace relievo
