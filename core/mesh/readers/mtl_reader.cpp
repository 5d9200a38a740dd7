// Wavefront MTL: which pictures a material of an OBJ file names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_uri.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/ground/text_cursor.h"
#include "core/image/sets/file_names.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace relievo {
namespace fs = std::filesystem;

namespace {
struct KeywordRow {
    std::string_view keyword; // lower case
    MapKind kind;
    bool invert = false;
};
constexpr KeywordRow kKeywords[] = {
    {"map_kd", MapKind::Color},
    {"map_ks", MapKind::Specular},
    {"map_ke", MapKind::Emission},
    {"map_ns", MapKind::Gloss},
    {"map_pr", MapKind::Roughness},
    {"map_pm", MapKind::Metallic},
    {"map_d", MapKind::Opacity},
    {"map_tr", MapKind::Opacity, true},
    {"map_ao", MapKind::AmbientOcclusion},
    {"bump", MapKind::Height}, // or a normal map, as the file's name says
    {"map_bump", MapKind::Height},
    {"disp", MapKind::Height},
    {"map_disp", MapKind::Height},
    {"norm", MapKind::Normal},
    {"map_kn", MapKind::Normal},
};

// Options of a texture line; each is followed by `least` to `most` words, of which those beyond `least` are numbers. -imfchan is followed
// where it can be, -boost to -blendv only filter the picture, -type is of reflection maps.
struct OptionRow {
    std::string_view option;
    int least, most;
    std::string_view neutral; // the words that change nothing, the last one for all that follow; "": never told
    std::string_view told, cure; // The material M `told` its picture; `cure`.
};
constexpr std::string_view kWithout = "it is shown without";
constexpr OptionRow kOptions[] = {
    {"-s", 1, 3, "1", "scales", "set tiling by hand"},
    {"-o", 1, 3, "0", "shifts", "set the offset by hand"},
    {"-t", 1, 3, "0", "gives turbulence to", kWithout},
    {"-mm", 2, 2, "0 1", "changes the values of", kWithout},
    {"-bm", 1, 1, "1", "sets the strength of", "set depth by hand"},
    {"-clamp", 1, 1, "off", "does not repeat", "set wrap by hand"},
    {"-cc", 1, 1, "off", "corrects the colors of", kWithout},
    {"-imfchan", 1, 1, "", "", ""},
    {"-boost", 1, 1, "", "", ""},
    {"-texres", 1, 1, "", "", ""},
    {"-blendu", 1, 1, "", "", ""},
    {"-blendv", 1, 1, "", "", ""},
    {"-type", 1, 1, "", "", ""},
};

struct TextureLine {
    std::string file;
    Channel channel = Channel::Rgb;
    std::set<const OptionRow*> notFollowed; // in the order of kOptions
    bool otherChannel = false; // matte or depth: -imfchan m or z
};

std::string_view spacesTrimmed(std::string_view text)
{
    const std::size_t from = std::min(text.find_first_not_of(" \t\r"), text.size());
    return text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
}

std::string unquoted(std::string name)
{
    return name.size() > 1 && name.front() == '"' && name.back() == '"' ? name.substr(1, name.size() - 2) : name;
}

bool isNeutral(const OptionRow& row, int at, std::string_view word)
{
    TextCursor neutrals(row.neutral);
    std::string_view neutral = neutrals.word();
    for (std::string_view next = neutrals.word(); at > 0 && !next.empty(); --at, next = neutrals.word())
        neutral = next;
    return neutral.empty() || lowered(word) == neutral || floatOf(word) == floatOf(neutral); // NaN equals nothing
}

// Options stand before the name, which is the rest of the line and may hold spaces.
TextureLine textureLine(std::string_view text)
{
    TextureLine line;
    for (;;) {
        TextCursor ahead(text);
        const std::string option = lowered(ahead.word());
        const auto* row = std::ranges::find(kOptions, option, &OptionRow::option);
        if (row == std::end(kOptions))
            break;
        for (int i = 0; i < row->most; ++i) {
            TextCursor one = ahead;
            const std::string_view word = one.word();
            const float number = floatOf(word);
            if (i >= row->least && (std::isnan(number) || spacesTrimmed(one.rest()).empty()))
                break; // the name begins
            if (!isNeutral(*row, i, word))
                line.notFollowed.insert(row);
            constexpr std::string_view kChannels = "rgb";
            if (option == "-imfchan" && word.size() == 1 && kChannels.find(word) != kChannels.npos)
                line.channel = Channel(kChannels.find(word));
            else if (option == "-imfchan")
                line.otherChannel = word != "l"; // luminance is what all three are read as
            ahead = one;
        }
        text = ahead.rest();
    }
    line.file = unquoted(std::string(spacesTrimmed(text)));
    return line;
}

// The names of a mtllib line that is no name as a whole: words, of which quoted ones may hold spaces.
std::vector<std::string> namesIn(std::string_view line)
{
    std::vector<std::string> names;
    while (!(line = spacesTrimmed(line)).empty()) {
        const std::size_t quote = line.front() == '"' ? line.find('"', 1) : line.npos;
        const std::size_t end = quote != line.npos ? quote + 1 : std::min(line.find_first_of(" \t"), line.size());
        names.push_back(unquoted(std::string(line.substr(0, end))));
        line.remove_prefix(end);
    }
    return names;
}

class MtlParser {
public:
    MtlParser(std::vector<fs::path> folders, std::vector<MeshMaterial>& materials, std::set<std::string>& names, Warnings& warnings)
        : m_folders(std::move(folders))
        , m_materials(materials)
        , m_names(names)
        , m_warnings(warnings)
    {
    }

    void parse(const std::string& text)
    {
        bool known = false; // whether the lines belong to a material that was not described before
        TextCursor lines(text);
        while (const std::optional<std::string_view> line = lines.line()) {
            TextCursor words(*line);
            const std::string keyword = lowered(words.word());
            if (keyword == "newmtl") {
                const std::string name(spacesTrimmed(words.rest()));
                known = m_names.insert(name).second;
                if (known)
                    m_materials.push_back({name, {}});
            } else if (const auto* row = std::ranges::find(kKeywords, keyword, &KeywordRow::keyword); known && row != std::end(kKeywords)) {
                addMap(m_materials.back(), *row, textureLine(words.rest()));
            }
        }
    }

private:
    void addMap(MeshMaterial& material, const KeywordRow& row, const TextureLine& line)
    {
        if (line.file.empty())
            return;
        std::optional<fs::path> file = findPicture(m_folders, line.file);
        if (!file) // some exporters write names as in the web: my%20scan.png
            file = findPicture(m_folders, percentDecoded(line.file));
        if (!file) {
            m_warnings.push_back({"map-missing",
                "The material \"" + material.name + "\" names the picture " + shownName(line.file)
                    + ", which is not there; put it beside the mesh."});
            return;
        }
        MapSlot slot{file->string(), line.channel, row.invert};
        MapKind kind = row.kind;
        if (const NameGuess guess = guessFromName(file->stem().string());
            kind == MapKind::Height && !guess.roles.empty() && guess.roles.front().kind == MapKind::Normal) {
            kind = MapKind::Normal;
            slot.invert = guess.convention == Convention::DX;
        }
        if (kind == MapKind::Opacity && slot.file == material.maps[std::size_t(MapKind::Color)].file)
            slot.channel = Channel::A; // a cut-out colour
        material.maps[std::size_t(kind)] = slot;
        const auto tell = [&](std::string_view told, std::string_view cure) {
            std::string text = "The material \"" + material.name + "\" ";
            m_warnings.push_back({"map-options", text.append(told) + ' ' + shownName(line.file) + "; " + std::string(cure) + '.'});
        };
        for (const OptionRow* option : line.notFollowed)
            tell(option->told, option->cure);
        if (line.otherChannel && slot.channel == Channel::Rgb)
            tell("takes another channel than red, green or blue of", "all are read");
    }

    std::vector<fs::path> m_folders;
    std::vector<MeshMaterial>& m_materials;
    std::set<std::string>& m_names; // of m_materials
    Warnings& m_warnings;
};
} // namespace

std::vector<MeshMaterial> readMtl(const fs::path& obj, std::span<const std::string> names, Warnings& warnings)
{
    std::vector<MeshMaterial> materials;
    std::set<std::string> materialNames, namesSeen;
    std::set<fs::path> filesSeen; // some exporters repeat the line for every object
    const fs::path folder = absolutePath(obj).parent_path();
    const auto readOne = [&](const fs::path& file) {
        if (!filesSeen.insert(file).second)
            return;
        if (const Expected<std::string> text = readText(file, std::size_t(64) << 20))
            MtlParser({file.parent_path(), folder}, materials, materialNames, warnings).parse(plainText(*text));
        else
            warnings.push_back({"material-missing", message(text.error())});
    };
    for (const std::string& name : names) {
        if (!namesSeen.insert(name).second)
            continue;
        if (const std::optional<fs::path> whole = findPicture({folder}, unquoted(name))) { // a name with spaces
            readOne(*whole);
            continue;
        }
        for (const std::string& one : namesIn(name))
            if (const std::optional<fs::path> found = findPicture({folder}, one))
                readOne(*found);
            else
                warnings.push_back({"material-missing",
                    "The mesh names the material file " + shownName(name) + ", which is not there; put it beside the mesh."});
    }
    return materials;
}

} // namespace relievo
