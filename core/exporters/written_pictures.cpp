// Telling pictures by their pixels, and keeping what was encoded.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/written_pictures.h"
#include "core/ground/file.h"
#include "core/ground/hash.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"

namespace relievo {
namespace {
using Bytes = std::shared_ptr<const std::vector<std::byte>>;

std::string contentOf(const Image& image, const std::string& suffix, bool srgb)
{
    return suffix + ' ' + std::to_string(image.width) + 'x' + std::to_string(image.height) + ' ' + std::to_string(image.channels) + ' '
        + std::to_string(int(image.type)) + (srgb ? " srgb " : " ") + hexHash(image.data);
}
} // namespace

Bytes bytesOf(const WrittenPictures& pictures, const std::string& content)
{
    const auto found = pictures.find(content);
    if (found == pictures.end())
        return nullptr;
    if (found->second.bytes)
        return found->second.bytes;
    auto read = readBytes(found->second.file);
    return read ? std::make_shared<const std::vector<std::byte>>(std::move(*read)) : nullptr;
}

Expected<void> writePicture(const ExportJob& job, const std::filesystem::path& file, const Image& image, bool srgb)
{
    if (!job.pictures)
        return writeImage(file, image, srgb);
    const std::string content = contentOf(image, lowerSuffix(file), srgb);
    if (const Bytes bytes = bytesOf(*job.pictures, content))
        return writeAtomically(file, *bytes);
    Expected<void> written = writeImage(file, image, srgb);
    if (written)
        (*job.pictures)[content] = {file, nullptr};
    return written;
}

Expected<Bytes> pngOf(const ExportJob& job, const Image& image, bool srgb)
{
    const std::string content = job.pictures ? contentOf(image, ".png", srgb) : std::string();
    if (const Bytes bytes = job.pictures ? bytesOf(*job.pictures, content) : nullptr)
        return bytes;
    Expected<std::vector<std::byte>> png = encodePng(image, srgb);
    if (!png)
        return tl::unexpected(png.error());
    Bytes bytes = std::make_shared<const std::vector<std::byte>>(std::move(*png));
    if (job.pictures)
        (*job.pictures)[content] = {{}, bytes};
    return bytes;
}

} // namespace relievo
