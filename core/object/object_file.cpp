// The JSON of an object, and the depths that it names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_file.h"
#include "core/ground/file.h"
#include "core/ground/json_depth.h"
#include "core/image/files/image_file.h"
#include "core/object/object_sides.h"
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
constexpr const char* kCure = "Bake the object again by relievo impostor";

struct Depths {
    fs::path file; // empty: not given
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
        if (kind != "depth" || !side.is_string() || !name.is_string() || !layer.is_number_integer())
            continue;
        const auto row = std::ranges::find(kObjectSides, side.get<std::string>(), &SideRow::key);
        const auto number = layer.get<std::int64_t>();
        if (row != kObjectSides.end() && number >= 1 && number <= kMostLayers)
            depths[std::size_t(row - kObjectSides.begin())][std::size_t(number - 1)].file = folder / name.get<std::string>();
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
            side->image = std::move(read->image);
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
    for (const auto& [side, other, row] : {std::tuple(&front, &back, 2 * axis), std::tuple(&back, &front, 2 * axis + 1)})
        if (!(*side)[0].image && (*other)[0].image)
            warnings.push_back({"side-missing",
                "The side " + std::string(kObjectSides[row].key) + " is missing: the object reaches to that side of its box."});
    return map;
}
} // namespace

Expected<ObjectRead> readObject(const fs::path& file)
{
    const auto text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    const json document = isNestedTooDeep(*text) ? json() : json::parse(*text, nullptr, false);
    if (document.is_discarded() || !document.is_object() || !member(document, "relievoObject").is_number())
        return failure(ErrorCode::Unreadable, file.string(), "this is no relief object", kCure);
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

} // namespace relievo
