// The JSON of an object, and the depths that it names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_file.h"
#include "core/ground/file.h"
#include "core/ground/json_depth.h"
#include "core/image/files/image_file.h"
#include "core/object/object_looks.h"
#include "core/object/object_sides.h"
#include "core/state/shapes.h"
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
constexpr const char* kCure = "Bake the object again by relievo impostor";

struct Depths {
    fs::path file; // empty: not given
    int channel = 0;
    bool inverted = false; // told from the other end of the axis
    std::optional<Image> image;
};
using SideDepths = std::array<std::array<Depths, kMostLayers>, kObjectSides.size()>;

std::optional<glm::dvec3> vectorOf(const json& value)
{
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, [](const json& v) { return v.is_number(); }))
        return {};
    return glm::dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

json member(const json& object, const char* key)
{
    return object.is_object() ? object.value(key, json()) : json();
}

Expected<void> readBox(const json& box, const fs::path& file, ReliefObject& object)
{
    const auto center = vectorOf(member(box, "center"));
    const json halves = member(box, "halfAxes");
    if (!center || !halves.is_array() || halves.size() != 3)
        return failure(ErrorCode::Unreadable, file.string(), "the box has no center and three half axes", kCure);
    object.center = *center;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto half = vectorOf(halves[i]);
        if (!half)
            return failure(ErrorCode::Unreadable, file.string(), "a half axis of the box is not three numbers", kCure);
        object.half[i] = *half;
    }
    return {};
}

// The depth maps that the file names, by side and layer.
SideDepths depthsOf(const json& maps, const fs::path& folder)
{
    SideDepths depths;
    for (const json& map : maps) {
        const json kind = member(map, "kind"), side = member(map, "side"), name = member(map, "file"), layer = member(map, "layer");
        const bool isPacked = kind == "packed";
        if ((kind != "depth" && !isPacked) || !side.is_string() || !name.is_string() || !(layer.is_number_integer() || layer.is_null()))
            continue;
        const auto row = std::ranges::find(kObjectSides, side.get<std::string>(), &SideRow::key);
        const auto number = layer.is_null() ? 1 : layer.get<std::int64_t>();
        if (row == kObjectSides.end() || number < 1 || number > kMostLayers)
            continue;
        const std::size_t k = std::size_t(number - 1);
        const fs::path file = folder / name.get<std::string>();
        depths[std::size_t(row - kObjectSides.begin())][k] = {file, isPacked ? 3 : 0, member(map, "convention") == "height", {}};
        if (isPacked) // both depths are told from the side
            depths[2 * row->axis + (row->isBack ? 0 : 1)][k] = {file, 2, true, {}};
    }
    return depths;
}

// Both sides of an axis.
Expected<AxisMap> readAxis(SideDepths& depths, std::size_t axis, Warnings& warnings)
{
    AxisMap map;
    auto &front = depths[2 * axis], &back = depths[2 * axis + 1];
    const Depths* first = nullptr;
    for (std::size_t k = 0; k < kMostLayers; ++k)
        for (Depths* side : {&front[k], &back[k]}) {
            if (side->file.empty())
                continue;
            auto read = readImage(side->file);
            if (!read)
                return tl::unexpected(read.error());
            side->image
                = side->channel != 0 || side->inverted ? channelOf(read->image, side->channel, side->inverted) : std::move(read->image);
            if (!first)
                first = side;
            else if (side->image->width != first->image->width || side->image->height != first->image->height)
                return failure(side->file.string(), "its size differs from that of " + first->file.filename().string(),
                    "The sides and layers of an axis lie on the same texels: " + std::string(kCure));
            map.layers = int(k) + 1;
        }
    if (!first)
        return map;
    map.width = first->image->width;
    map.height = first->image->height;
    map.intervals.resize(first->image->texelCount() * std::size_t(map.layers));
    const auto image = [](const Depths& side) { return side.image ? &*side.image : nullptr; };
    for (std::size_t k = 0; k < std::size_t(map.layers); ++k)
        if (image(front[k]) || image(back[k]))
            setLayer(map, int(k), image(front[k]), image(back[k]));
    for (std::size_t i = 0; i < map.intervals.size(); ++i) { // of packed pictures: as deep as can be from the side that they are of
        const std::size_t k = i % std::size_t(map.layers);
        Interval& interval = map.intervals[i];
        if ((front[k].channel == 3 && interval.front == Interval::kDeepest) || (back[k].channel == 3 && interval.back == 0))
            interval = {};
    }
    for (const auto& [side, other, row] : {std::tuple(&front, &back, 2 * axis), std::tuple(&back, &front, 2 * axis + 1)})
        if (!(*side)[0].image && (*other)[0].image)
            warnings.push_back({"side-missing",
                "The side " + std::string(kObjectSides[row].key) + " is missing: the object reaches to that side of its box."});
    return map;
}
} // namespace

namespace {
Expected<json> readDocument(const fs::path& file)
{
    const auto text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    json document = isNestedTooDeep(*text) ? json() : json::parse(*text, nullptr, false);
    if (document.is_discarded() || !document.is_object() || !member(document, "relievoObject").is_number())
        return failure(ErrorCode::Unreadable, file.string(), "this is no relief object", kCure);
    return document;
}

Expected<ObjectRead> objectOf(const json& document, const fs::path& file)
{
    ObjectRead read;
    if (const auto box = readBox(member(document, "box"), file, read.object); !box)
        return tl::unexpected(box.error());
    SideDepths depths = depthsOf(member(document, "maps"), file.parent_path());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto map = readAxis(depths, axis, read.warnings);
        if (!map)
            return tl::unexpected(map.error());
        read.object.axes[axis] = std::move(*map);
    }
    auto faults = checkObject(read.object);
    if (!faults)
        return failure(ErrorCode::Unreadable, file.string(), faults.error().where + ": " + faults.error().what, kCure);
    read.warnings.insert(read.warnings.end(), faults->begin(), faults->end());
    // A file that holds one side alone says so.
    if (member(document, "sides") == 1)
        std::erase_if(read.warnings, [](const Warning& warning) { return warning.code == "side-missing"; });
    return read;
}

struct LookRow {
    std::string_view kind;
    std::optional<Image> SideLook::*image;
};
constexpr std::array<LookRow, 3> kLooks
    = {{{"color", &SideLook::color}, {"normal", &SideLook::normal}, {"roughness", &SideLook::roughness}}};

std::string sourceOf(const json& document, const fs::path& folder)
{
    const json mesh = member(document, "mesh");
    const std::string name = mesh.is_string() ? mesh.get<std::string>() : std::string();
    return name.empty() || std::ranges::count(kShapes, name) > 0 ? name : absolutePath(folder / name).string();
}

// Without those that cannot be read, which are told.
void readLooks(const json& named, const fs::path& folder, ObjectMaps& maps, const Progress& progress)
{
    for (std::size_t i = 0; i < named.size() && !progress.cancelled(); ++i) {
        const json kind = member(named[i], "kind"), side = member(named[i], "side"), name = member(named[i], "file");
        if (!kind.is_string() || !side.is_string() || !name.is_string())
            continue;
        const bool isPacked = kind == "packed"; // its normals
        const auto look = std::ranges::find(kLooks, isPacked ? "normal" : kind.get<std::string>(), &LookRow::kind);
        const auto row = std::ranges::find(kObjectSides, side.get<std::string>(), &SideRow::key);
        if (look == kLooks.end() || row == kObjectSides.end())
            continue;
        auto read = readImage(folder / name.get<std::string>());
        if (read && isPacked)
            maps.looks[std::size_t(row - kObjectSides.begin())].normal = normalsOfXy(read->image);
        else if (read)
            maps.looks[std::size_t(row - kObjectSides.begin())].*look->image = std::move(read->image);
        else
            maps.warnings.push_back({"side-picture-missing", message(read.error())});
        progress.at(float(i + 1) / float(named.size()));
    }
}
} // namespace

void completeLooks(ObjectMaps& maps)
{
    for (std::size_t side = 0; side < maps.looks.size(); ++side) {
        const SideRow& row = kObjectSides[side];
        SideLook &look = maps.looks[side], &other = maps.looks[2 * row.axis + (row.isBack ? 0 : 1)];
        if (!maps.object.axes[row.axis].isGiven())
            continue;
        if (!look.normal)
            look.normal = normalsOfDepths(maps.object, row.axis, row.isBack);
        look.color = look.color ? std::move(look.color) : other.color;
        look.roughness = look.roughness ? std::move(look.roughness) : other.roughness;
    }
}

Expected<ObjectRead> readObject(const fs::path& file)
{
    const auto document = readDocument(file);
    return document ? objectOf(*document, file) : tl::unexpected(document.error());
}

Expected<ObjectMaps> readObjectMaps(const fs::path& file, const Progress& progress)
{
    const auto document = readDocument(file);
    if (!document)
        return tl::unexpected(document.error());
    auto read = objectOf(*document, file);
    if (!read)
        return tl::unexpected(read.error());
    ObjectMaps maps{std::move(read->object), {}, {}, sourceOf(*document, file.parent_path()), std::move(read->warnings)};
    progress.at(0.4f);
    maps.texels = objectTexels(maps.object);
    if (const json named = member(*document, "maps"); named.is_array())
        readLooks(named, file.parent_path(), maps, progress.part(0.5f, 1.f));
    completeLooks(maps);
    if (progress.cancelled())
        return cancelled(file.string());
    return maps;
}

} // namespace relievo
