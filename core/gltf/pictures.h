// The pictures that a mesh file names or holds: finding them, and taking them out of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/shown_text.h"
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace relievo {

// The existing file that `name` means in a file of `folders`' first: as written (backslashes, drive letters and absolute paths of other
// machines allowed), else by its last part alone; each in any case of letters, Unicode form and code page.
// Absolute. Nothing when there is none.
std::optional<std::filesystem::path> findPicture(const std::vector<std::filesystem::path>& folders, std::string name);

// "FILE#N": picture N inside a glTF file. namesEmbeddedPicture is false for a file that exists under that very name.
std::string embeddedPictureName(const std::filesystem::path& gltf, int picture);
bool namesEmbeddedPicture(const std::filesystem::path& name);

// "FILE.exr#NAME": a layer of an EXR file. Nothing for a file that exists under that very name.
struct NamedLayer {
    std::filesystem::path file;
    std::string layer;
};
std::optional<NamedLayer> layerOf(const std::filesystem::path& name);
std::string layerName(const std::filesystem::path& exr, const std::string& layer);

// The file in which a picture lies: `name` itself, one whose name looks alike, or the glTF or EXR file that holds it.
std::filesystem::path fileOfPicture(const std::filesystem::path& name);

// Whether there is a file of that name, or the glTF or EXR file that should hold the picture.
bool pictureMayExist(const std::filesystem::path& name);

// The undecoded bytes (PNG, JPEG ...). Errors name the file.
Expected<std::vector<std::byte>> readEmbeddedPicture(const std::filesystem::path& name);

} // namespace relievo
