// Export target "textures": a folder with each map as its own file, and relief.json with the physical numbers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/exporters/written_pictures.h"
#include "core/ground/file.h"
#include "core/maps/maps.h"
#include "core/scene/relief_numbers.h"
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;

namespace {
using Json = nlohmann::ordered_json;

std::optional<Image> imageOf(MapKind kind, const ExportJob& job, const Parameters& parameters)
{
    const Material& material = *job.resources.material;
    if (kind == MapKind::Height)
        return material.height ? std::optional(reduced(heightImage(*material.height, 16), job.size, Averaging::Plain)) : std::nullopt;
    if (kind == MapKind::Normal) {
        const std::optional<Image> normal = normalImage(material, parameters, job.progress);
        return normal ? std::optional(reduced(*normal, job.size, Averaging::Normals)) : std::nullopt;
    }
    const Image* map = material.map(kind);
    if (!map)
        return std::nullopt;
    const Image image = reduced(*map, job.size, row(kind).isColor ? Averaging::Srgb : Averaging::Plain);
    return image.type != PixelType::F32 ? image : row(kind).isColor ? eightBit(image, true) : withBits(image, 16);
}

// The numbers that turn the maps into relief elsewhere (what relief.json holds).
Json numbersOf(const ExportJob& job, const Parameters& parameters)
{
    const float measured = job.resources.mesh->metresPerUV;
    const float depth = physicalDepth(parameters, measured), unit = metresPerUV(parameters, measured);
    Json numbers = {{"name", job.state.name}, {"depthMetres", shortest(depth)}, {"depthUV", shortest(depth / unit)}};
    for (const auto& [key, parameter] : kReliefNumbers)
        numbers[key] = shortest(parameters.*parameter);
    numbers.update({{"metresPerUV", shortest(unit)}, {"tileMetres", shortest(unit / parameters.tiling)},
        {"offset", {shortest(parameters.offsetU), shortest(parameters.offsetV)}}, {"wrap", wordOf(parameters.wrap)},
        {"technique", techniqueOf(job)}});
    return numbers;
}

bool isWritten(MapKind kind, const Material& material)
{
    return kind == MapKind::Height ? material.height.has_value()
        : kind == MapKind::Normal  ? material.height || material.map(kind)
                                   : material.map(kind) != nullptr;
}

struct MapFile {
    const MapKindRow* kind;
    fs::path path;
};
std::vector<MapFile> mapFilesOf(const ExportJob& job)
{
    std::vector<MapFile> files;
    const std::string stem = fileStem(job.state.name);
    for (const MapKindRow& kind : kMapKinds)
        if (isWritten(kind.kind, *job.resources.material))
            files.push_back({&kind, job.out / (stem + '_' + std::string(kind.fileName) + ".png")});
    return files;
}

// Where the material's maps go; an error when that is where one was read.
Expected<std::vector<MapFile>> checkedFilesOf(const ExportJob& job)
{
    std::vector<MapFile> files = mapFilesOf(job);
    if (files.empty())
        return failure(job.out.string(), "the material has no maps to write", "Open a texture set first");
    for (const MapFile& file : files)
        if (Expected<void> free = refuseToOverwriteSources(job, file.path); !free)
            return tl::unexpected(free.error());
    if (Expected<void> free = refuseToOverwriteSources(job, job.out / "relief.json"); !free)
        return tl::unexpected(free.error());
    return files;
}

Expected<void> writeNumbers(const ExportJob& job, const Json& numbers)
{
    return writeAtomically(job.out / "relief.json", numbers.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

Warnings lossesOf(const Material& material)
{
    Warnings losses;
    if (!material.height)
        losses.push_back({"no-height", "The material has no height map: the folder holds no relief."});
    else if (!material.map(MapKind::Normal))
        losses.push_back({"normal-made", "The normal map was made from the height map at the material's depth."});
    const Image* emission = material.map(MapKind::Emission);
    if (emission && brightest(*emission) > 1.f)
        losses.push_back({"emission-clipped", "Emission brighter than 1 was clipped: PNG cannot hold it."});
    return losses;
}
} // namespace

std::vector<fs::path> filesOfTextures(const ExportJob& job)
{
    std::vector<fs::path> files{job.out / "relief.json"};
    for (const MapFile& file : mapFilesOf(job))
        files.push_back(file.path);
    return files;
}

// relief.json comes before the maps and says that it is not all, so that a folder left in the middle is seen to be one (kUnfinishedExport).
Expected<Exported> exportTextures(const ExportJob& job)
{
    const Expected<std::vector<MapFile>> files = checkedFilesOf(job);
    if (!files)
        return tl::unexpected(files.error());
    NewFiles made;
    if (Expected<void> folder = made.makeFolder(job.out); !folder)
        return tl::unexpected(folder.error());
    const Parameters parameters = parametersOf(job);
    Json numbers = numbersOf(job, parameters), maps = Json::array();
    Json unfinished = numbers;
    unfinished[kUnfinishedExport] = true;
    Exported exported{{}, lossesOf(*job.resources.material)};
    for (const auto& [kind, path] : *files) {
        job.progress.at(float(exported.files.size()) / float(files->size()));
        const std::optional<Image> image = imageOf(kind->kind, job, parameters);
        if (job.progress.cancelled())
            return cancelled(job.out.string());
        if (!image)
            continue;
        if (exported.files.empty()) {
            made.willMake(job.out / "relief.json");
            if (Expected<void> written = writeNumbers(job, unfinished); !written)
                return tl::unexpected(written.error());
        }
        made.willMake(path);
        if (Expected<void> written = writePicture(job, path, *image, kind->isColor); !written)
            return tl::unexpected(written.error());
        exported.files.push_back(path);
        maps.push_back({{"kind", kind->key}, {"file", path.filename().string()}, {"convention", kind->convention}, {"width", image->width},
            {"height", image->height}, {"bits", image->type == PixelType::U8 ? 8 : 16}});
    }
    numbers["maps"] = maps;
    if (Expected<void> written = writeNumbers(job, numbers); !written)
        return tl::unexpected(written.error());
    exported.files.push_back(job.out / "relief.json");
    made.keep();
    return exported;
}

} // namespace relievo
