// relievo bake: one row of the maps table, computed from the height map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include "core/maps/maps.h"
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace relievo::cli {

namespace {

struct BakeOptions {
    Common common;
    StateOptions state;
    std::string out, map;
    int bits = 16;
};

struct Baked {
    BakedMap map; // as stored
    Image image; // as written
    double seconds = 0.;
    std::optional<float> depth; // tiles, of a map made from normals
    Warnings warnings;
};

// From the height map, or for a map made from normals from the normal map.
Expected<BakedMap> bakeFrom(
    const Material& material, const BakedMapRow& row, const Parameters& parameters, std::optional<float>& depth, const Progress& progress)
{
    const Wrap wrap = parameters.wrap;
    if (!row.bakeFromNormals)
        return material.height ? bakeMap(row, material.height->withWrap(wrap), parameters, progress)
                               : failure(std::string(row.key), "the material has no height map to bake from", "Add one by --height FILE");
    const Image* normals = material.map(MapKind::Normal);
    if (!normals)
        return failure(std::string(row.key), "the material has no normal map to bake from", "Add one by --normal FILE");
    return bakeMapFromNormals(row, *normals, wrap, depth.emplace(0.f), progress);
}

// All levels or slices one below the other; two channels as red and green, which every program shows.
Image asPicture(const BakedMap& map)
{
    const Image& first = map.levels.front();
    const int channels = first.channels == 2 ? 3 : first.channels;
    Image picture{first.width, 0, channels, first.type, first.storedBits, first.storedFloat, {}};
    for (const Image& level : map.levels)
        picture.height += level.height;
    const std::size_t value = bytesOf(first.type), from = value * std::size_t(first.channels), to = value * std::size_t(channels);
    picture.data.resize(picture.texelCount() * to);
    std::byte* row = picture.data.data();
    for (const Image& level : map.levels)
        for (int y = 0; y < level.height; ++y, row += std::size_t(picture.width) * to)
            for (int x = 0; x < level.width; ++x)
                std::memcpy(row + std::size_t(x) * to,
                    level.data.data() + (std::size_t(y) * std::size_t(level.width) + std::size_t(x)) * from, from);
    return picture;
}

// Whether the format holds what is asked for.
Result<void> check(const BakeOptions& options, const BakedMapRow& row)
{
    if (row.form == MapForm::Codes && options.bits != 16)
        return problem({"this map is codes of 16 bits", "--bits " + std::to_string(options.bits), "Leave --bits out"}, WrongUsage);
    const std::string suffix = lowerSuffix(options.out);
    const bool eight = suffix == ".jpg" || suffix == ".jpeg" || suffix == ".bmp" || suffix == ".tga";
    const int most = eight ? 8 : suffix == ".png" || suffix == ".hdr" ? 16 : 32;
    if (options.bits > most)
        return problem({"a " + suffix + " holds " + std::to_string(most) + " bits a channel at most, not " + std::to_string(options.bits),
                           "-o " + options.out, eight ? "Write .png or .exr, or add --bits 8" : "Write .exr or .tif"},
            WrongUsage);
    return {};
}

Result<Baked> bake(const BakeOptions& options)
{
    const BakedMapRow* row = findBakedMap(options.map);
    if (!row)
        return problem({"there is no such map", "--map " + options.map, "relievo describe maps lists them"}, WrongUsage);
    if (const auto fits = check(options, *row); !fits)
        return tl::unexpected(fits.error());
    const Progress progress = shownProgress(options.common);
    auto opened = openState(options.state, progress.part(0.f, 0.2f));
    if (!opened)
        return tl::unexpected(opened.error());
    auto material = loadMaterial(opened->state.slots, opened->images, nullptr, progress.part(0.2f, 0.4f));
    if (!material)
        return problem(material.error());
    Baked out;
    const auto start = std::chrono::steady_clock::now();
    auto map = bakeFrom(*material, *row, effectiveParameters(opened->state, 0), out.depth, progress.part(0.4f, 0.9f));
    if (!map)
        return problem(map.error());
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    out.map = options.bits == 32 ? std::move(*map) : storedMap(*row, *map, options.bits);
    out.image = asPicture(out.map);
    if (const auto written = writeImage(options.out, out.image); !written)
        return problem(written.error());
    progress.at(1.f);
    out.warnings = opened->warnings;
    out.warnings.insert(out.warnings.end(), material->warnings.begin(), material->warnings.end());
    return out;
}

nlohmann::ordered_json toJson(const BakeOptions& options, const Baked& baked)
{
    const BakedMapRow& row = *findBakedMap(options.map);
    nlohmann::ordered_json levels = nlohmann::ordered_json::array(), scale = levels, encoding = levels;
    for (const Image& level : baked.map.levels)
        levels.push_back({level.width, level.height / baked.map.slices});
    for (int c = 0; c < row.channels; ++c) {
        scale.push_back(baked.map.scale[c]);
        encoding.push_back(options.bits != 32 && row.rules[std::size_t(c)].encoding == Encoding::SquareRoot ? "root" : "linear");
    }
    nlohmann::ordered_json json{{"file", options.out}, {"map", options.map}, {"unit", row.unit}, {"bits", options.bits},
        {"seconds", baked.seconds}, {"width", baked.image.width}, {"height", baked.image.height}, {"slices", baked.map.slices},
        {"levels", levels}, {"scale", scale}, {"encoding", encoding}};
    if (baked.depth)
        json["depth"] = *baked.depth;
    json["warnings"] = warningsJson(baked.warnings);
    return json;
}

// What a user must know to read the values back.
void tellScale(const BakedMapRow& row, const BakeOptions& options, const Baked& baked)
{
    for (int c = 0; c < row.channels && !options.common.quiet && options.bits != 32; ++c) {
        const bool root = row.rules[std::size_t(c)].encoding == Encoding::SquareRoot;
        if (root || baked.map.scale[c] != 1.f)
            std::printf("channel %d: value = %.9g x %s\n", c + 1, double(baked.map.scale[c]), root ? "stored^2" : "stored");
    }
    if (baked.depth && !options.common.quiet)
        std::printf("depth: %.6g tile\n", double(*baked.depth));
}

} // namespace

void addBake(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = app.add_subcommand("bake", "Computes a map from the height map, or heights from the normal map");
    command->footer(
        "The levels of a pyramid stand one below the other from the finest down, each at the left; so do the slices of a volume or "
        "of horizons, the first on top. Two channels are written as red and green.");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--map", options->map, "What to bake, see relievo describe maps")->required()->type_name("KEY");
    options->state.addOutput(*command, "-o", options->out, "Image to write; the suffix names the format")->required()->type_name("OUT");
    command
        ->add_option("--bits", options->bits,
            "Bits a channel; 16 when not given. 8 and 16: stored in [0, 1], ratios and distances as roots, rounded to the safe side; the "
            "scale of each channel is told. 32: the values themselves, as floats")
        ->check(CLI::IsMember({8, 16, 32}))
        ->type_name("8|16|32");
    command->callback([options, &exitCode] {
        const auto baked = bake(*options);
        if (!baked) {
            exitCode = tell(baked.error());
            return;
        }
        tell(baked->warnings, options->common);
        if (options->common.json)
            print(toJson(*options, *baked));
        else
            tellScale(*findBakedMap(options->map), *options, *baked);
    });
}

} // namespace relievo::cli
