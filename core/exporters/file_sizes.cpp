// Guessing sizes by maps, formats and meshes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/file_sizes.h"
#include "core/exporters/engines/packing.h"
#include "core/exporters/map_images.h"
#include "core/ground/text.h"
#include <algorithm>

namespace relievo {
namespace {
// Bytes written for one byte of pixels: a guess.
struct FormatRow {
    std::string_view suffix;
    double eightBits, more;
};
constexpr FormatRow kFormats[] = {{".png", 0.6, 0.75}, {".jpg", 0.12, 0.12}, {".exr", 0.6, 0.6}, {".tif", 0.7, 0.8}, {".tga", 1., 1.}};
constexpr double kVertexBytes = 48., kIndexBytes = 4., kBase64 = 4. / 3.;

double pictureBytes(double texels, int channels, int bits, std::string_view suffix)
{
    const auto format = std::ranges::find(kFormats, suffix, &FormatRow::suffix);
    return format == std::end(kFormats) ? 0. : texels * channels * bits / 8. * (bits == 8 ? format->eightBits : format->more);
}

// Of a map as it is written; 0 where there is none.
double texelsOf(const ExportJob& job, MapKind kind)
{
    const Material& material = *job.resources.material;
    const Image* const map = material.map(kind);
    const bool isOfHeights = kind == MapKind::Height || (kind == MapKind::Normal && !map);
    int width = map ? map->width : 0, height = map ? map->height : 0;
    if (isOfHeights && material.height)
        width = material.height->width(), height = material.height->height();
    const int longest = std::max(width, height);
    const double scale = job.size > 0 && longest > job.size ? double(job.size) / longest : 1.;
    return width * scale * height * scale;
}

double textureBytes(const ExportJob& job, const PackedTexture& texture)
{
    double texels = 1.;
    for (const PackedChannel& channel : texture.channels) {
        const bool isMap = channel.from == PackedChannel::From::Map, isNormal = channel.from == PackedChannel::From::Normal;
        if (channel.from != PackedChannel::From::Constant)
            texels = std::max(texels, texelsOf(job, isMap ? channel.kind : isNormal ? MapKind::Normal : MapKind::Height));
    }
    return pictureBytes(texels, int(texture.channels.size()), texture.bits, lowerSuffix(texture.file));
}

double textBytes(const ExportRow& row, const ExportJob& job, const std::string& name)
{
    constexpr std::string_view kName = "{{name}}";
    for (const PackedTexture& texture : (job.packing ? *job.packing : textOf(row)).textures) {
        std::string file = texture.file;
        if (const std::size_t at = file.find(kName); at != std::string::npos)
            file.replace(at, kName.size(), fileStem(job.state.name));
        if (file == name)
            return textureBytes(job, texture);
    }
    return 0.;
}

// One file that holds mesh and maps.
double wholeBytes(const ExportJob& job)
{
    double bytes = 0.;
    if (const Mesh* mesh = job.resources.mesh.get())
        bytes += double(mesh->vertices.size()) * kVertexBytes + double(mesh->indices.size()) * kIndexBytes;
    for (const MapKind kind : {MapKind::Color, MapKind::Normal})
        bytes += pictureBytes(texelsOf(job, kind), 3, 8, ".png");
    double packed = 0.;
    for (const MapKind kind : {MapKind::AmbientOcclusion, MapKind::Roughness, MapKind::Metallic})
        packed = std::max(packed, texelsOf(job, kind));
    return bytes + pictureBytes(packed, 3, 8, ".png");
}
} // namespace

double aboutBytes(const ExportRow& row, const ExportJob& job, const std::filesystem::path& file)
{
    const std::string suffix = lowerSuffix(file);
    const double height = pictureBytes(texelsOf(job, MapKind::Height), 1, 16, ".png");
    if (!row.code)
        return textBytes(row, job, file.lexically_relative(job.out).string());
    if (suffix == ".glb" || suffix == ".bin")
        return wholeBytes(job);
    if (suffix == ".html")
        return (wholeBytes(job) + height) * kBase64;
    for (const MapKindRow& kind : kMapKinds)
        if (suffix == ".png" && kind.kind != MapKind::Height && file.stem().string().ends_with('_' + std::string(kind.fileName)))
            return pictureBytes(texelsOf(job, kind.kind), kind.channels, kind.kind == MapKind::Normal ? 16 : 8, suffix);
    return suffix == ".png" ? height : 0.;
}

} // namespace relievo
