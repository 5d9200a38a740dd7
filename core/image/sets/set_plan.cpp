// Listing folders and choosing the set to open.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/set_plan.h"
#include "core/gltf/pictures.h"
#include "core/ground/foreign_file.h"
#include "core/image/sets/texture_set.h"
#include <algorithm>
#include <array>

namespace relievo {
namespace fs = std::filesystem;
namespace {
constexpr std::string_view kImageSuffixes
    = "png jpg jpeg tif tiff tx exr hdr rgbe tga tpic bmp dds webp psd ppm pgm pbm pnm"; // as the helper knows
std::string suffixOf(const fs::path& file)
{
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return suffix.empty() ? suffix : suffix.substr(1);
}

} // namespace

bool isPicture(const fs::path& file)
{
    const std::string suffix = suffixOf(file);
    const bool named = !suffix.empty() && (" " + std::string(kImageSuffixes) + " ").find(" " + suffix + " ") != std::string::npos;
    return named && !(suffix == "hdr" && foreignFile(file)); // headers of elevation data bear the same suffix
}

namespace {
struct Listing {
    std::vector<fs::path> images, folders, others; // sorted
};

Expected<Listing> listFolder(const fs::path& folder)
{
    Listing listing;
    std::error_code code;
    for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
        std::error_code ignored;
        const fs::path& path = it->path();
        if (path.filename().string().starts_with('.'))
            continue;
        (it->is_directory(ignored) ? listing.folders : isPicture(path) ? listing.images : listing.others).push_back(path);
    }
    if (code)
        return failure(folder.string(), "the folder cannot be read (" + code.message() + ")", "Check its permissions");
    for (auto* list : {&listing.images, &listing.folders, &listing.others})
        std::ranges::sort(*list);
    return listing;
}

// Downloads often keep their images one folder down ("textures").
Expected<Listing> listImages(const fs::path& folder)
{
    Expected<Listing> listing = listFolder(folder);
    if (!listing || !listing->images.empty())
        return listing;
    std::vector<Listing> below;
    for (const fs::path& sub : listing->folders)
        if (Expected<Listing> inner = listFolder(sub); inner && !inner->images.empty())
            below.push_back(std::move(*inner));
    if (below.size() == 1)
        return std::move(below[0]);
    for (const fs::path& other : listing->others)
        if (std::optional<Error> foreign = foreignFile(other))
            return tl::unexpected(std::move(*foreign));
    return failure(folder.string(),
        below.empty() ? "there is no readable image in this folder" : "the images lie in several folders below this one",
        below.empty() ? "Choose a folder with PNG, JPEG, TIFF, EXR, TGA, BMP, HDR or DDS files" : "Choose one of them");
}

void tellOthers(const std::vector<FileGroup>& groups, SetPlan& plan)
{
    std::vector<std::string> sets, strays;
    for (std::size_t i = 1; i < groups.size(); ++i) {
        if (groups[i].kinds() > 0)
            sets.push_back(groups[i].title.empty() ? groups[i].files[0].file.filename().string() : groups[i].title);
        for (const NamedFile& file : groups[i].plain)
            strays.push_back(file.file.filename().string());
    }
    if (!sets.empty())
        plan.warnings.push_back(
            {"several-sets", "the folder holds other sets too: " + shortList(sets) + "; name an image of one to open it"});
    if (!strays.empty())
        plan.warnings.push_back({"ignored-file", "not used, their names tell no kind of map: " + shortList(strays)});
}

// A set's own name on an image without a kind means its colour.
void addGroup(const FileGroup& group, SetPlan& plan)
{
    plan.files = group.files;
    for (NamedFile file : group.plain) {
        if (!group.files.empty()) {
            file.guess.roles = {{MapKind::Color, Channel::Rgb}};
            file.guess.rank = kNoKindRank;
        }
        plan.files.push_back(std::move(file));
    }
    plan.name = group.title;
}

NamedFile asHeight(const fs::path& file)
{
    NamedFile named{file, guessFromName(file.stem().string())};
    named.guess.roles = {{MapKind::Height, Channel::Rgb}};
    named.guess.packing = Packing::None;
    named.guess.weak = false;
    named.guess.vague = '\0';
    named.guess.convention = endsInDepth(file.stem().string()) ? Convention::Depth : Convention::Height;
    return named;
}

Expected<SetPlan> planFolder(const fs::path& folder)
{
    const Expected<Listing> listing = listImages(folder);
    if (!listing)
        return tl::unexpected(listing.error());
    SetPlan plan;
    plan.folder = folder;
    const std::vector<FileGroup> groups = groupFiles(listing->images);
    if (groups[0].kinds() > 0) {
        addGroup(groups[0], plan);
        tellOthers(groups, plan);
    } else if (listing->images.size() == 1) {
        plan.files = {asHeight(listing->images[0])};
        plan.name = listing->images[0].stem().string();
    } else {
        return failure(folder.string(), "no image here has a name that tells which map it is",
            "Name them like rock_color.png and rock_height.png, or set maps by hand (--height FILE)");
    }
    if (plan.name.empty())
        plan.name = folder.filename().string();
    return plan;
}

// An image without siblings is a height map. A normal map or a packed file would make no sense as one.
Expected<SetPlan> planImage(const fs::path& file)
{
    if (std::optional<Error> foreign = foreignFile(file))
        return tl::unexpected(std::move(*foreign));
    SetPlan plan;
    plan.folder = file.parent_path();
    plan.name = file.stem().string();
    Expected<Listing> listing = listFolder(plan.folder);
    if (!listing || std::ranges::find(listing->images, file) == listing->images.end()) {
        plan.files = {asHeight(file)};
        return plan;
    }
    const std::vector<FileGroup> groups = groupFiles(listing->images);
    const FileGroup& group = *std::ranges::find_if(groups, [&](const FileGroup& one) { return one.contains(file); });
    const bool alone = group.files.size() + group.plain.size() == 1;
    if (alone || group.files.empty()) {
        const NamedFile named{file, guessFromName(file.stem().string())};
        const bool speaks = !group.files.empty() && (named.guess.packing != Packing::None || named.guess.roles[0].kind == MapKind::Normal);
        plan.files = {speaks ? named : asHeight(file)};
        return plan;
    }
    addGroup(group, plan);
    if (plan.name.empty())
        plan.name = plan.folder.filename().string();
    return plan;
}

} // namespace

namespace {
// Tiles of the chosen files beside them: each covers a square of the UVs of its own, and one is shown.
void tellUdim(SetPlan& plan)
{
    const NamedFile* first = nullptr;
    for (const NamedFile& file : plan.files)
        if (!first && udimTile(file.file.stem().string()))
            first = &file;
    const Expected<Listing> listing = first ? listFolder(plan.folder) : Expected<Listing>(Listing());
    if (!first || !listing)
        return;
    const UdimTile chosen = *udimTile(first->file.stem().string());
    std::vector<std::string> others;
    for (const fs::path& image : listing->images)
        if (const auto tile = udimTile(image.stem().string()); tile && tile->base == chosen.base && tile->number != chosen.number)
            others.push_back(std::to_string(tile->number));
    if (others.empty())
        return;
    std::erase_if(plan.warnings, [](const Warning& warning) { return warning.code == "several-sets"; });
    plan.warnings.push_back({"udim",
        first->file.filename().string() + " is one of the UDIM tiles " + std::to_string(chosen.number) + ", " + shortList(others)
            + ": only tile " + std::to_string(chosen.number)
            + " is shown, on all of the mesh; name an image of another tile to open that"});
}
} // namespace

namespace {
// The image that leads to a group: its largest file, as what is named wins over better ones of its kind.
fs::path sourceOf(const FileGroup& group)
{
    const auto size = [](const NamedFile& one) {
        std::error_code code;
        const std::uintmax_t bytes = fs::file_size(one.file, code);
        return code ? 0 : bytes;
    };
    return std::ranges::max_element(group.files, {}, size)->file;
}
} // namespace

std::vector<SetInFolder> setsIn(const fs::path& folder)
{
    std::vector<SetInFolder> sets;
    const Expected<Listing> listing = listFolder(folder);
    if (!listing)
        return sets;
    if (listing->images.empty())
        for (const fs::path& below : listing->folders)
            if (const Expected<Listing> inner = listFolder(below); inner && !inner->images.empty())
                sets.push_back({below.filename().string(), below});
    std::vector<std::string> tiled; // what UDIM tiles are named before their numbers
    for (const FileGroup& group : groupFiles(listing->images)) {
        if (group.files.empty())
            continue;
        const auto tile = udimTile(group.files[0].file.stem().string());
        if (tile && std::ranges::count(tiled, tile->base))
            continue;
        if (tile)
            tiled.push_back(tile->base);
        sets.push_back({group.title.empty() ? group.files[0].file.filename().string() : group.title, sourceOf(group)});
    }
    return sets;
}

std::string shortList(const std::vector<std::string>& names)
{
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i)
        text += (i > 0 ? ", " : "") + names[i];
    return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

Expected<SetPlan> planSource(const fs::path& source)
{
    std::error_code code;
    const fs::file_status status = fs::status(source, code);
    if (!fs::exists(status) && !pictureMayExist(source))
        return failure(ErrorCode::NotFound, source.string(), "there is no such file or folder", "Check the path");
    Expected<SetPlan> plan = fs::is_directory(status) ? planFolder(source) : planImage(source);
    if (plan)
        tellUdim(*plan);
    return plan;
}

} // namespace relievo
