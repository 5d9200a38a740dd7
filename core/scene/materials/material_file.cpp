// Engines' materials as States, by the table of dialects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/materials/material_file.h"
#include "core/ground/file.h"
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/ground/shown_text.h"
#include "core/ground/srgb.h"
#include "core/ground/text.h"
#include "core/scene/materials/material_dialects.h"
#include "core/scene/materials/material_fields.h"
#include "core/scene/relief_numbers.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace relievo {
namespace fs = std::filesystem;

namespace {
constexpr std::size_t kLargestMaterial = std::size_t(16) << 20; // bytes
constexpr int kMostFoldersUp = 16;

using Reader = Expected<MaterialFields> (*)(std::string_view text, const fs::path& file);
struct Format {
    std::string_view suffix;
    Reader read;
};
constexpr auto kFormats = std::to_array<Format>({
    {".tres", readGodotMaterial},
    {".mat", readUnityMaterial},
    {".material", readJsonMaterial},
    {".json", readJsonMaterial},
    {".babylon", readJsonMaterial},
    {".mtlx", readMaterialX},
});

std::string_view valueOf(const MaterialFields& fields, std::string_view property)
{
    const auto found = fields.find(property);
    return found == fields.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> numberOf(const MaterialFields& fields, std::string_view property)
{
    const std::string text(valueOf(fields, property));
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return end != text.c_str() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// "KEY": it is neither missing nor zero nor false. "KEY=VALUE": it is as told.
bool holds(const MaterialFields& fields, std::string_view condition)
{
    const std::size_t equals = condition.find('=');
    const std::string_view value = valueOf(fields, condition.substr(0, equals));
    if (equals != std::string_view::npos)
        return value == condition.substr(equals + 1);
    return !value.empty() && value != "false" && numberOf(fields, condition) != 0.;
}

// 0 to 3, 4 for grey, or letters.
Channel channelOf(std::string_view value, Channel untold)
{
    constexpr std::string_view kNumbers = "0123", kLetters = "rgba";
    if (value == "4" || value == "rgb")
        return Channel::Rgb;
    if (value.size() == 1)
        for (const std::string_view names : {kNumbers, kLetters})
            if (const std::size_t at = names.find(value); at != std::string_view::npos)
                return Channel(at);
    return untold;
}

// As a path of the engine's project says it: beside the material, in a folder above, or the name alone beside it.
std::optional<fs::path> pictureFile(const fs::path& material, std::string_view named)
{
    std::string name(named);
    std::ranges::replace(name, '\\', '/');
    for (const std::string_view scheme : {"res://", "file://", "@projectroot@/", "./"})
        if (name.starts_with(scheme))
            name.erase(0, scheme.size());
    if (name.empty())
        return std::nullopt;
    const fs::path beside = material.parent_path();
    std::error_code code;
    fs::path folder = beside;
    for (int up = 0; up < kMostFoldersUp && folder.has_relative_path(); ++up, folder = folder.parent_path())
        if (fs::is_regular_file(folder / name, code))
            return folder / name;
    for (const fs::path& file : {beside / name, beside / fs::path(name).filename()})
        if (auto found = thatLooksLike(file); found && fs::is_regular_file(*found, code))
            return found;
    return std::nullopt;
}

const MaterialDialect* dialectOf(const MaterialFields& fields)
{
    const std::string_view type = valueOf(fields, "$type");
    const auto names = [](std::string_view types, std::string_view wanted) {
        return !wanted.empty() && (' ' + std::string(types) + ' ').find(' ' + std::string(wanted) + ' ') != std::string::npos;
    };
    if (const auto row = std::ranges::find_if(kMaterialDialects, [&](const MaterialDialect& d) { return names(d.types, type); });
        row != kMaterialDialects.end())
        return row;
    const auto known = [&](const MaterialDialect& dialect) { // shaders of studios' own keep the names that Unity's have
        return std::ranges::count_if(dialect.pictures, [&](const PictureProperty& p) { return fields.contains(p.property); });
    };
    const auto best = std::ranges::max_element(kMaterialDialects, {}, known);
    return known(*best) > 0 ? best : nullptr;
}

class Reading {
public:
    Reading(const MaterialDialect& dialect, const MaterialFields& fields, const fs::path& file, const State& base)
        : m_dialect(dialect)
        , m_fields(fields)
        , m_file(file)
        , m_read{base, {}}
    {
        m_read.state.slots = {};
        const std::string_view name = valueOf(fields, "$name");
        m_read.state.name = name.empty() ? file.stem().string() : std::string(name);
    }

    MaterialRead read() &&
    {
        takePictures();
        takeNumbers();
        if (has(Height))
            takeDepth();
        return std::move(m_read);
    }

private:
    bool has(MapKind kind) const { return !m_read.state.slots[std::size_t(kind)].empty(); }

    void takePictures()
    {
        for (const PictureProperty& picture : m_dialect.pictures) {
            const std::string_view named = valueOf(m_fields, picture.property);
            if (named.empty() || has(picture.kind) || (!picture.when.empty() && !holds(m_fields, picture.when)))
                continue;
            if (const auto file = pictureFile(m_file, named))
                m_read.state.slots[std::size_t(picture.kind)] = {.file = file->string(),
                    .channel = channelOf(valueOf(m_fields, picture.channelFrom), picture.channel),
                    .invert = picture.invert != (!picture.invertFrom.empty() && holds(m_fields, picture.invertFrom))};
            else
                m_read.warnings.push_back({"map-missing",
                    std::string(picture.property) + ": " + shownText(named) + " was not found near " + m_file.filename().string()
                        + ". Give the " + std::string(row(picture.kind).key) + " map by hand."});
        }
    }

    void takeNumbers()
    {
        MeshFactors factors{.metallic = float(has(Metallic) ? m_dialect.metallicUntold : 0.), .emission = 1.f};
        for (const NumberProperty& number : m_dialect.numbers)
            if (const auto value = numberOf(m_fields, number.property); value && !(number.unless && has(*number.unless))) {
                const double taken = number.times * *value + number.plus;
                if (const auto factor = std::get_if<float MeshFactors::*>(&number.target))
                    factors.** factor = float(taken);
                else
                    takeNumber(m_read.state, std::get<std::string_view>(number.target), taken);
            }
        constexpr std::array<const char*, 3> letters = {".r", ".g", ".b"}, digits = {".0", ".1", ".2"};
        for (int c = 0; c < 3; ++c)
            for (const auto& names : {letters, digits})
                if (const auto value = numberOf(m_fields, std::string(m_dialect.color) + names[std::size_t(c)]))
                    factors.color[c] = m_dialect.colorIsSrgb ? linearOf(float(*value)) : float(*value);
        factors.clamped = !m_dialect.clamped.empty() && holds(m_fields, m_dialect.clamped);
        takeFactors(m_read.state, factors, m_read.state.slots);
        const auto u = numberOf(m_fields, m_dialect.offsetU), v = numberOf(m_fields, m_dialect.offsetV);
        if (!u || !v)
            return;
        const Parameters& p = m_read.state.parameters;
        const double turn = m_dialect.offsetIsTurned ? double(p.rotation) * std::numbers::pi / 180 : 0., tiling = double(p.tiling);
        takeNumber(m_read.state, "offsetU", *u + tiling * std::sin(turn));
        takeNumber(m_read.state, "offsetV", 1 - *v - tiling * std::cos(turn));
    }

    void takeDepth()
    {
        const std::optional<double> told = numberOf(m_fields, m_dialect.depth);
        if (!told && m_dialect.depthUntold == 0)
            return;
        double depth = told.value_or(m_dialect.depthUntold) / m_dialect.depthFactor;
        State& state = m_read.state;
        takeNumber(state, "midlevel", numberOf(m_fields, m_dialect.midlevelFrom).value_or(m_dialect.midlevel));
        if (m_dialect.inMetres) {
            const auto perUV = numberOf(m_fields, m_dialect.metresPerUV);
            if (perUV && *perUV > 0)
                takeNumber(state, "metresPerUV", *perUV);
            const double unit = double(metresPerUV(state.parameters, 1.f));
            if (!perUV)
                m_read.warnings.push_back({"depth-in-metres",
                    std::string(m_dialect.label) + " tells the depth in metres: it is taken for a mesh with "
                        + toText(*findParameter("metresPerUV"), float(unit)) + " m per UV unit."});
            depth *= double(state.parameters.tiling) / unit;
        }
        takeNumber(state, "depth", depth);
    }

    const MaterialDialect& m_dialect;
    const MaterialFields& m_fields;
    const fs::path& m_file;
    MaterialRead m_read;
};
} // namespace

bool isMaterialFile(const fs::path& file)
{
    return std::ranges::count(kFormats, lowerSuffix(file), &Format::suffix) > 0;
}

Expected<MaterialRead> readMaterialFile(const fs::path& file, const State& base)
{
    const auto format = std::ranges::find(kFormats, lowerSuffix(file), &Format::suffix);
    if (format == kFormats.end())
        return failure(file.string(), "this is no material of an engine");
    const Expected<std::string> text = readText(file, kLargestMaterial);
    if (!text)
        return tl::unexpected(text.error());
    const Expected<MaterialFields> fields = format->read(*text, file);
    if (!fields)
        return tl::unexpected(fields.error());
    const MaterialDialect* dialect = dialectOf(*fields);
    MaterialRead read = dialect ? Reading(*dialect, *fields, file, base).read() : MaterialRead{};
    if (read.state.slots != MapSlots())
        return read;
    if (!read.warnings.empty())
        return failure(ErrorCode::NotFound, file.string(), "none of its textures was found near it",
            "Put them beside it, or open them by their folder");
    const std::optional<Error> foreign = foreignFile(file); // knows a cure
    return failure(file.string(), "this material" + (dialect ? " of " + std::string(dialect->label) : "") + " names no texture",
        foreign ? foreign->hint : "Open its textures by their folder");
}

} // namespace relievo
