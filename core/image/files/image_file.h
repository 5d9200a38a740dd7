// Reading and writing image files through the helper process relievo-imageio (core/imageio): a broken file can end it, never the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/image.h"
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace relievo {

// What a file's header says; no pixels are decoded.
struct ImageInfo {
    int width = 0, height = 0, channels = 0;
    int storedBits = 8;
    bool storedFloat = false;
    std::vector<std::string> layers = {}; // names of an EXR file's layers, when there are several; the first is read where none is named
};

// Largest number of texels kept of one image; a larger one is box-reduced by a whole factor while it is read.
inline constexpr std::size_t kMaxTexels = std::size_t(8192) * 8192;

struct ImageRead {
    Image image;
    Warnings warnings; // "reduced", "cmyk", "no-alpha-premultiply" ...: what the user should know
};

// All functions are safe to call from several threads (two requests are answered at once, others wait for their turn). Errors name the file
// and the cure. A crash, hang (20 s without progress) or memory bomb of the image library is an error; the helper is respawned.
// `file` may also be "FILE.glb#N", picture N inside a glTF file, or "FILE.exr#NAME", a layer (core/gltf/pictures.h).
Expected<ImageInfo> readImageInfo(const std::filesystem::path& file);
Expected<ImageRead> readImage(const std::filesystem::path& file, const Progress& progress = {});

// Starts the helpers ahead of the first request, which then need not wait until they have loaded their libraries. Returns at once.
void startImageHelpers();

// A texture inside a .glb or a data URI: the undecoded bytes of a PNG or JPEG. `name` stands in messages.
Expected<ImageRead> readImageBytes(std::span<const std::byte> bytes, const std::string& name);

// Writes by the suffix of `file` (png tif exr hdr tga jpg bmp), atomically: beside it, flushed, renamed.
// A U16 image stays 16 bit where the format can (png, tif), F32 stays float (exr, hdr, tif), else it is rounded to 8 or 16 bits.
// srgb: the values are sRGB encoded colour (tagged so where the format can); they are never converted here.
Expected<void> writeImage(const std::filesystem::path& file, const Image& image, bool srgb = false);

// Layers of one EXR: all of the same size, F32; channels are named LAYER.R, LAYER.G ... (the first layer without a prefix).
struct ImageLayer {
    std::string name;
    Image image;
};
Expected<void> writeLayers(const std::filesystem::path& exrFile, std::span<const ImageLayer> layers);

// The encoded bytes of a PNG (8 or 16 bit), for embedding in a .glb.
Expected<std::vector<std::byte>> encodePng(const Image& image, bool srgb = false);

} // namespace relievo
