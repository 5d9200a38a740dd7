// Wavefront MTL: which pictures a material of an OBJ file names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file.h"
#include "core/image/file_names.h"
#include "core/mesh/pictures.h"
#include "core/mesh/raw_mesh.h"
#include "core/mesh/text_cursor.h"
#include "core/text.h"
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

// Options of a texture line; each is followed by `least` to `most` words, of which those beyond `least` are numbers.
struct OptionRow {
    std::string_view option;
    int least, most;
    float neutral; // the number that changes nothing; NaN: never told
};
constexpr float kNever = std::numeric_limits<float>::quiet_NaN();
constexpr OptionRow kOptions[] = {
    {"-s", 1, 3, 1.f},
    {"-o", 1, 3, 0.f},
    {"-t", 1, 3, 0.f},
    {"-mm", 2, 2, kNever},
    {"-bm", 1, 1, kNever}, // a strength: depth is the user's
    {"-boost", 1, 1, kNever},
    {"-texres", 1, 1, kNever},
    {"-blendu", 1, 1, kNever},
    {"-blendv", 1, 1, kNever},
    {"-cc", 1, 1, kNever},
    {"-clamp", 1, 1, kNever},
    {"-imfchan", 1, 1, kNever},
    {"-type", 1, 1, kNever},
};

struct TextureLine {
    std::string file;
    Channel channel = Channel::Rgb;
    bool moved = false; // scaled, shifted or turbulent by its options
};

std::string_view spacesTrimmed(std::string_view text)
{
    const std::size_t from = std::min(text.find_first_not_of(" \t\r"), text.size());
    return text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
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
            line.moved |= !std::isnan(row->neutral) && number != row->neutral;
            constexpr std::string_view kChannels = "rgb";
            if (option == "-imfchan" && word.size() == 1 && kChannels.find(word) != kChannels.npos)
                line.channel = Channel(kChannels.find(word));
            ahead = one;
        }
        text = ahead.rest();
    }
    line.file = spacesTrimmed(text);
    if (line.file.size() > 1 && line.file.front() == '"' && line.file.back() == '"')
        line.file = line.file.substr(1, line.file.size() - 2);
    return line;
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
        const std::optional<fs::path> file = findPicture(m_folders, line.file);
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
        if (line.moved)
            m_warnings.push_back({"map-options",
                "The material \"" + material.name + "\" scales or shifts " + shownName(line.file)
                    + "; set tiling by hand, these options are not followed."});
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
        if (const std::optional<fs::path> whole = findPicture({folder}, name)) { // a name with spaces
            readOne(*whole);
            continue;
        }
        TextCursor words(name);
        for (std::string_view word = words.word(); !word.empty(); word = words.word())
            if (const std::optional<fs::path> found = findPicture({folder}, std::string(word)))
                readOne(*found);
            else
                warnings.push_back({"material-missing",
                    "The mesh names the material file " + shownName(name) + ", which is not there; put it beside the mesh."});
    }
    return materials;
}

} // namespace relievo
