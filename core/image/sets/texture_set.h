// Finding the maps of a material: file names and pixels of a folder, or of one image and its siblings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/files/image_file.h"
#include "core/state/map_slots.h"
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace relievo {

// Decoded images by file, so that a set is read once however many maps are packed in a file and whoever asks.
using DecodedImages = std::map<std::filesystem::path, std::shared_ptr<const ImageRead>>;

// How a map is to be read, as measured from its pixels where it can be, else as its name says.
enum class Convention { Height, Depth, GL, DX, Unsure, Srgb, Linear };
constexpr std::string_view wordOf(Convention convention)
{
    switch (convention) {
    case Convention::Height:
        return "height";
    case Convention::Depth:
        return "depth";
    case Convention::GL:
        return "gl";
    case Convention::DX:
        return "dx";
    case Convention::Unsure:
        return "unsure";
    case Convention::Srgb:
        return "srgb";
    case Convention::Linear:
        return "linear";
    }
    return {};
}

struct FoundMap {
    MapKind kind;
    std::filesystem::path file; // absolute
    Channel channel = Channel::Rgb;
    ImageInfo info;
    Convention convention = Convention::Linear;
    double min = 0, max = 0; // over the channel as stored (integers as value / max), before any flip
};

struct TextureSet {
    std::string name; // "Rock_024", shown to the user
    std::filesystem::path folder; // files are shown relative to this
    std::vector<FoundMap> maps; // at most one per kind, in the order of kMapKinds
    DecodedImages images; // every image that was decoded for measuring
    Warnings warnings; // what was converted, guessed or ignored, in the user's words
    EnumSet<MapKind> coming; // of a set that is told early: maps whose files are still being read
    MapSlots slots() const; // as the State stores them: depth -> invert, DX -> green flip
};

// Hears of a set while the rest of it is being read, each time that there is more of it, but not before its heights. Names and pixels of
// what is there decide; the whole set may decide otherwise. Called from any thread, never twice at once.
using EarlySet = std::function<void(const TextureSet&)>;

// source: a folder, or one image of a set (siblings by the same stem), or a single image without siblings: it is a height map
// (a depth map when its stem ends in "depth"). Reads pixels to measure conventions (resources/help/command-line.md, "What info tells").
// Errors: nothing there, no readable image, unsupported container (KTX, KTX2, raw float) named as such.
Expected<TextureSet> openTextureSet(const std::filesystem::path& source, const Progress& progress = {}, const EarlySet& early = {});

// The sets to choose from in a folder, the most complete one first: those that lie in it, or, where no images do, the folders below it that
// hold some. Only names are looked at. UDIM tiles are one set. Nothing when the folder cannot be read.
struct SetInFolder {
    std::string title; // shown to the user
    std::filesystem::path source; // for openTextureSet: an image of the set, or a folder
};
std::vector<SetInFolder> setsIn(const std::filesystem::path& folder);

// What "FILE#r" (g, b, a) names; any other name stands for all channels of itself.
std::pair<std::filesystem::path, Channel> fileAndChannel(const std::filesystem::path& given);

// The slot for a file that the user gives by hand; "FILE#r" (g, b, a) reads one channel of it. A normal map in DirectX style, as its pixels
// show or else its name says, is flipped with the warning "normal-directx"; a height map whose name ends in "depth" is inverted. Decoded
// pixels are added to `images`. A file that cannot be read is no error here: loading it will be.
MapSlot slotByHand(MapKind kind, const std::filesystem::path& file, DecodedImages& images, Warnings& warnings);

// The set that slots describe, for `info` of a project or sample: conventions as the slots say. Files that cannot be read become
// warnings.
TextureSet textureSetOf(const std::string& name, const MapSlots& slots, const std::filesystem::path& folder);

// `info SOURCE --json` (resources/help/command-line.md, "What info tells").
std::string textureSetJson(const TextureSet& set);

} // namespace relievo
