// A target as text: which textures it takes, and the files that go with them, as templates (Mustache) over named values.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include <memory>
#include <string>
#include <vector>

namespace relievo {

inline constexpr std::string_view kOwnMap = "*";

// One channel of a written texture.
struct PackedChannel {
    enum class From { Constant, Height, Map, Normal, Baked } from = From::Constant;
    float value = 0.f; // of a constant
    MapKind kind = MapKind::Height; // of a map
    int channel = 0; // of the map, of the normal (x y z), or of the baked map
    bool inverted = false; // 1 - value
    std::string baked = {}; // key of kBakedMaps; kOwnMap: of the technique that is exported, in as many channels as it has
    enum class Part { All, HighByte, LowByte } part = Part::All; // of 16 bits
    std::string word; // as the file says it: "roughness", "normal_y_directx", "cone_relaxed_g", "1.0"
};
struct PackedTexture {
    std::string key; // what the templates call it
    std::string file; // its name, a template of `name` alone; the suffix is the format
    std::vector<PackedChannel> channels; // 1 to 4
    int bits = 8; // 8, 16 or 32 (float)
    bool srgb = false; // holds colour as it is stored
    enum class When { Always, EightBitsShow, ExactSearch, FilteredSearch, Codes, NoCodes } when = When::Always; // it is written
    bool holdsHeight() const;
    bool holdsData() const; // numbers that mip levels and compression would spoil: heights and baked maps
};
constexpr std::string_view wordOf(PackedTexture::When when)
{
    switch (when) {
    case PackedTexture::When::Always:
        return "always";
    case PackedTexture::When::EightBitsShow:
        return "8 bits show";
    case PackedTexture::When::ExactSearch:
        return "exact search";
    case PackedTexture::When::FilteredSearch:
        return "filtered search";
    case PackedTexture::When::Codes:
        return "codes";
    case PackedTexture::When::NoCodes:
        return "no codes";
    }
    return {};
}
inline constexpr std::string_view kTextureSuffixes[] = {".png", ".tif", ".tga", ".jpg", ".exr"};
inline constexpr int kTextureBits[] = {8, 16, 32};
struct TargetFile {
    std::string name; // template; relative, never out of the folder
    std::string text; // template
    bool eachTexture = false; // once for each texture that is written, whose values are named too
    int line = 0; // of `text` in the target's file, for messages
};
struct TargetText {
    std::string where; // file, or KEY.tpl of the program's own
    std::vector<PackedTexture> textures;
    std::vector<TargetFile> files;
    // A user's own row; its views look into `words`.
    std::unique_ptr<ExportRow> own = {};
    std::unique_ptr<const std::vector<std::string>> words = {};
};

// JSON alone (packed textures), or JSON followed by sections that begin with a line "=== NAME" or "=== NAME each texture". Errors name the
// line, or the member, and what would be right. `isOwn`: the JSON tells the row as well (key from the file's name).
Expected<TargetText> parseTarget(const std::string& text, const std::string& where, bool isOwn);

// A user's packing: a file of JSON alone. Errors: unreadable, and those of parseTarget.
Expected<TargetText> readPacking(const std::filesystem::path& file);

// The text of a row that code does not write; of the program's own one of resources/exports, named by the key.
const TargetText& textOf(const ExportRow& row);

// A user's target: .json or .tpl. Kept until the program ends, so that the row may be used like those of kExports.
Expected<const ExportRow*> ownTarget(const std::filesystem::path& file);

// A channel's word; nothing when it is none.
std::optional<PackedChannel> channelOf(const std::string& word);
std::vector<std::string> channelWords(); // all of them but the numbers

// The JSON that parseTarget reads as these textures. Of a channel its word alone counts.
std::string packingText(const std::vector<PackedTexture>& textures);

} // namespace relievo
