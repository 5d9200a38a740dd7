// Guessing sizes by what a few rows of the maps take.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/file_sizes.h"
#include "core/exporters/engines/packing.h"
#include "core/exporters/map_images.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace relievo {
namespace {
// Bytes written for one byte of pixels, where no rows are tried: a guess.
struct FormatRow {
    std::string_view suffix;
    double share;
};
constexpr FormatRow kFormats[] = {{".png", 0.5}, {".jpg", 0.12}, {".exr", 0.6}, {".tif", 0.7}, {".tga", 1.}};
constexpr double kVertexBytes = 48., kIndexBytes = 4., kBase64 = 4. / 3.;
constexpr int kBands = 4, kBandRows = 16; // of a picture as it is written: PNG looks back about as far

double guessedShare(std::string_view suffix)
{
    const auto format = std::ranges::find(kFormats, suffix, &FormatRow::suffix);
    return format == std::end(kFormats) ? 0. : format->share;
}

// First rows of the bands of so many rows each; {0} where they would be all of `height`.
std::vector<int> bandsOf(int height, int& rows)
{
    if (height <= kBands * rows) {
        rows = height;
        return {0};
    }
    std::vector<int> first;
    for (int band = 0; band < kBands; ++band)
        first.push_back(int(std::int64_t(height - rows) * band / (kBands - 1)));
    return first;
}

Image inBands(const Image& image, int rows)
{
    const std::vector<int> first = bandsOf(image.height, rows);
    Image bands = emptyImage(image.width, rows * int(first.size()), image.channels, image.type);
    bands.storedBits = image.storedBits, bands.storedFloat = image.storedFloat;
    const std::size_t rowBytes = std::size_t(image.width) * std::size_t(image.channels) * bytesOf(image.type);
    for (std::size_t i = 0; i < first.size(); ++i)
        std::memcpy(bands.data.data() + i * std::size_t(rows) * rowBytes, image.data.data() + std::size_t(first[i]) * rowBytes,
            std::size_t(rows) * rowBytes);
    return bands;
}

HeightField inBands(const HeightField& field, int rows)
{
    const std::vector<int> first = bandsOf(field.height(), rows);
    std::vector<float> heights;
    for (const int row : first)
        for (int y = row; y < row + rows; ++y)
            for (int x = 0; x < field.width(); ++x)
                heights.push_back(field.texel(x, y));
    return HeightField(field.width(), rows * int(first.size()), std::move(heights), field.wrap(), field.storedBits());
}

// The job with a few rows of each map.
class SmallJob {
public:
    explicit SmallJob(const ExportJob& job) : m_whole(job), m_resources(job.resources)
    {
        const Material& material = *job.resources.material;
        const auto look = [this](int width, int height) {
            m_longest = std::max({m_longest, width, height}), m_width = std::max(m_width, width);
        };
        for (const auto& map : material.maps)
            if (map)
                look(map->width, map->height);
        if (material.height)
            look(material.height->width(), material.height->height());
        const bool isReduced = job.size > 0 && job.size < m_longest;
        m_size = isReduced ? std::max(1, int(std::lround(double(job.size) * m_width / m_longest))) : 0;
        m_rows = isReduced ? (kBandRows * m_longest + job.size - 1) / job.size : kBandRows;
        Material few = material;
        for (auto& map : few.maps)
            if (map)
                map = std::make_shared<const Image>(inBands(*map, m_rows));
        if (few.height)
            few.height = inBands(*few.height, m_rows);
        m_resources.material = std::make_shared<const Material>(std::move(few));
    }

    ExportJob job() const
    {
        return {m_whole.state, m_resources, m_whole.out, m_size, Progress{{}, m_whole.progress.stop}, {}, m_whole.cures, nullptr,
            m_whole.packing};
    }

    // Of the whole picture, of which this is a part: as PNG, or by the share of another format.
    double bytesOf(const Image& part, double wholeTexels, std::string_view suffix = ".png") const
    {
        const double raw = double(part.data.size()), share = wholeTexels / std::max(1., double(part.texelCount()));
        if (suffix != ".png")
            return raw * share * guessedShare(suffix);
        const auto png = encodePng(part);
        return png ? double(png->size()) * share : 0.;
    }

    // Of a map as it is written; 0 where there is none.
    double texelsOf(MapKind kind) const
    {
        const Material& material = *m_whole.resources.material;
        const Image* const map = material.map(kind);
        const bool isOfHeights = kind == MapKind::Height || (kind == MapKind::Normal && !map);
        int width = map ? map->width : 0, height = map ? map->height : 0;
        if (isOfHeights && material.height)
            width = material.height->width(), height = material.height->height();
        const int longest = std::max(width, height);
        const double scale = m_whole.size > 0 && longest > m_whole.size ? double(m_whole.size) / longest : 1.;
        return width * scale * height * scale;
    }

private:
    const ExportJob& m_whole;
    Resources m_resources;
    int m_longest = 0, m_width = 0, m_size = 0, m_rows = 0; // of the largest map; of the bands
};

double textureBytes(const SmallJob& small, const PackedTexture& texture)
{
    using From = PackedChannel::From;
    double texels = 1.;
    for (const PackedChannel& channel : texture.channels)
        if (channel.from != From::Constant)
            texels = std::max(texels,
                small.texelsOf(channel.from == From::Map ? channel.kind
                        : channel.from == From::Normal   ? MapKind::Normal
                                                         : MapKind::Height));
    const std::string suffix = lowerSuffix(texture.file);
    if (std::ranges::any_of(texture.channels, [](const PackedChannel& c) { return c.from == From::Baked; }))
        return texels * double(texture.channels.size()) * texture.bits / 8. * guessedShare(suffix); // nothing is baked for a guess
    const ExportJob job = small.job();
    const Parameters parameters = parametersOf(job);
    const Image part = packed(texture, job, writtenHeights(job, parameters), parameters);
    return small.bytesOf(part, texels, suffix);
}

double textBytes(const ExportRow& row, const ExportJob& job, const SmallJob& small, const std::string& name)
{
    constexpr std::string_view kName = "{{name}}";
    for (const PackedTexture& texture : (job.packing ? *job.packing : textOf(row)).textures) {
        std::string file = texture.file;
        if (const std::size_t at = file.find(kName); at != std::string::npos)
            file.replace(at, kName.size(), fileStem(job.state.name));
        if (file == name)
            return textureBytes(small, texture);
    }
    return 0.;
}

// A map as the texture folder holds it.
double mapBytes(const SmallJob& small, MapKind kind)
{
    const ExportJob job = small.job();
    const Material& material = *job.resources.material;
    std::optional<Image> image;
    if (kind == MapKind::Height && material.height)
        image = reduced(heightImage(*material.height, 16), job.size, Averaging::Plain);
    else if (kind == MapKind::Normal)
        image = normalImage(material, parametersOf(job), job.progress);
    else if (const Image* map = material.map(kind))
        image = map->type == PixelType::F32 ? eightBit(*map, row(kind).isColor) : *map;
    return image ? small.bytesOf(reduced(*image, job.size, Averaging::Plain), small.texelsOf(kind)) : 0.;
}

// One file that holds mesh and maps of 8 bits.
double wholeBytes(const ExportJob& whole, const SmallJob& small)
{
    const ExportJob job = small.job();
    const Material& material = *job.resources.material;
    double bytes = 0.;
    if (const Mesh* mesh = whole.resources.mesh.get())
        bytes += double(mesh->vertices.size()) * kVertexBytes + double(mesh->indices.size()) * kIndexBytes;
    if (const auto color = baseColorImage(material, job.size))
        bytes += small.bytesOf(*color, std::max(small.texelsOf(MapKind::Color), small.texelsOf(MapKind::Opacity)));
    double packedTexels = 0.;
    for (const MapKind kind : {MapKind::AmbientOcclusion, MapKind::Roughness, MapKind::Gloss, MapKind::Metallic})
        packedTexels = std::max(packedTexels, small.texelsOf(kind));
    if (const auto packed = packedImage(material, job.size))
        bytes += small.bytesOf(*packed, packedTexels);
    if (const auto normal = normalImage(material, parametersOf(job), job.progress))
        bytes += small.bytesOf(eightBit(reduced(*normal, job.size, Averaging::Normals), false), small.texelsOf(MapKind::Normal));
    return bytes;
}
} // namespace

double aboutBytes(const ExportRow& row, const ExportJob& job, const std::filesystem::path& file)
{
    const std::string suffix = lowerSuffix(file);
    const SmallJob small(job);
    if (!row.code)
        return textBytes(row, job, small, file.lexically_relative(job.out).string());
    if (suffix == ".glb" || suffix == ".bin") {
        const ExportJob few = small.job();
        const double height = few.resources.material->height
            ? small.bytesOf(
                reduced(heightImage(*few.resources.material->height, 8), few.size, Averaging::Plain), small.texelsOf(MapKind::Height))
            : 0.;
        return wholeBytes(job, small) + height;
    }
    if (suffix == ".html") // a bound map of 8 bytes a texel beside the heights
        return (wholeBytes(job, small) + mapBytes(small, MapKind::Height) + small.texelsOf(MapKind::Height) * 8. * guessedShare(".png"))
            * kBase64;
    for (const MapKindRow& kind : kMapKinds)
        if (suffix == ".png" && kind.kind != MapKind::Height && file.stem().string().ends_with('_' + std::string(kind.fileName)))
            return mapBytes(small, kind.kind);
    return suffix == ".png" ? mapBytes(small, MapKind::Height) : 0.;
}

} // namespace relievo
