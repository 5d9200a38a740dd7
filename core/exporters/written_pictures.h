// Writing the pictures of an export: one that several targets hold is encoded once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"

namespace relievo {

// As writeImage and encodePng, but for what the job's `pictures` know already.
Expected<void> writePicture(const ExportJob& job, const std::filesystem::path& file, const Image& image, bool srgb = false);
Expected<std::shared_ptr<const std::vector<std::byte>>> pngOf(const ExportJob& job, const Image& image, bool srgb = false);

// The bytes of a picture that was written; null when there is none, or when it is gone.
std::shared_ptr<const std::vector<std::byte>> bytesOf(const WrittenPictures& pictures, const std::string& content);

} // namespace relievo
