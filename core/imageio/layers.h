// The layers of an EXR file: groups of channels that are a picture of their own, over all its parts.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <OpenImageIO/imageio.h>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::imageio {

// "depth" of "depth.R", or the part's name for channels R, G, B, A and Y without one; any other channel is a layer by itself.
struct Layer {
    std::string name; // "" for the plain channels of a part without a name
    int part = 0;
    int firstChannel = 0, channels = 0; // of that part
};

// At least one, in the file's order. `input` is open at its first part. At most kMaxLayers are found.
inline constexpr std::size_t kMaxLayers = 256;
std::vector<Layer> layersOf(OIIO::ImageInput& input);

// Names of all, for messages and for choosing: those without one are "plain".
std::vector<std::string> namesOf(const std::vector<Layer>& layers);

} // namespace relievo::imageio
