// What a web page holds of the large data, as JSON: pictures as PNG, numbers in base64.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include "core/image/environment/environment.h"
#include "core/image/image.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/mesh/mesh.h"
#include <nlohmann/json.hpp>

namespace relievo {

using WebJson = nlohmann::ordered_json;

// Whole numbers of 16 bits, which browsers cut to 8 in one PNG: of each channel a grey PNG of the high bytes and one of the low ones.
// {width, height, channels, planes}. Errors: those of the encoder.
Expected<WebJson> webPlanes(const ExportJob& job, const Image& image);

// 8 bits a channel: {png, channels, srgb}.
Expected<WebJson> webPicture(const ExportJob& job, const Image& image, bool srgb);

// The finest level: webPlanes with `sampler`, the name in shaders, and the slices of a volume.
Expected<WebJson> webBound(const ExportJob& job, const AccelerationMap& map);

// Positions, normals and uvs as 32-bit floats, indices of 16 or 32 bits, those of parts with relief first: {relief: how many}.
WebJson webMesh(const Mesh& mesh, const std::vector<char>& isPlain);

// At most kWebEnvironmentSide texels a side, so that a page stays small. Faces of each level, one after the other, as numbers of 32 bits
// (RGB9_E5): {side, levels, texels}.
inline constexpr int kWebEnvironmentSide = 128;
WebJson webEnvironment(const Environment& environment);

} // namespace relievo
