// The words for a texture's channels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/target_text.h"
#include "core/maps/maps.h"
#include <charconv>

namespace relievo {
namespace {
using From = PackedChannel::From;
constexpr std::string_view kLetters = "rgba";

std::vector<PackedChannel> allChannels()
{
    std::vector<PackedChannel> all;
    const auto add = [&all](From from, MapKind kind, int channel, bool inverted, std::string word, std::string baked = {}) {
        all.push_back({from, 0.f, kind, channel, inverted, std::move(baked), PackedChannel::Part::All, std::move(word)});
    };
    add(From::Height, MapKind::Height, 0, false, "height");
    add(From::Height, MapKind::Height, 0, true, "depth");
    add(From::Height, MapKind::Height, 0, false, "height_high_byte");
    all.back().part = PackedChannel::Part::HighByte;
    add(From::Height, MapKind::Height, 0, false, "height_low_byte");
    all.back().part = PackedChannel::Part::LowByte;
    for (int axis = 0; axis < 3; ++axis)
        add(From::Normal, MapKind::Normal, axis, false, std::string("normal_") + "xyz"[axis]);
    add(From::Normal, MapKind::Normal, 1, true, "normal_y_directx");
    for (const MapKindRow& row : kMapKinds) {
        if (row.kind == MapKind::Height || row.kind == MapKind::Normal || row.kind == MapKind::Gloss)
            continue;
        for (int c = 0; c < row.channels; ++c)
            add(From::Map, row.kind, c, false,
                std::string(row.key) + (row.channels > 1 ? std::string("_") + kLetters[std::size_t(c)] : ""));
    }
    add(From::Map, MapKind::Roughness, 0, true, "smoothness");
    for (const BakedMapRow& row : kBakedMaps) {
        if (row.bakeFromNormals || row.key == "normal")
            continue;
        std::string key(row.key);
        std::ranges::replace(key, '-', '_');
        if (findMapKind(key))
            key = "baked_" + key;
        for (int c = 0; c < row.channels; ++c)
            add(From::Baked, MapKind::Height, c, false, row.channels > 1 ? key + '_' + kLetters[std::size_t(c)] : key,
                std::string(row.key));
    }
    const std::pair<const char*, PackedChannel::Part> parts[] = {
        {"bound_", PackedChannel::Part::All}, {"bound_high_", PackedChannel::Part::HighByte}, {"bound_low_", PackedChannel::Part::LowByte}};
    for (const auto& [word, part] : parts)
        for (int c = 0; c < 4; ++c) {
            add(From::Baked, MapKind::Height, c, false, word + std::string(1, kLetters[std::size_t(c)]), std::string(kOwnMap));
            all.back().part = part;
        }
    return all;
}
} // namespace

bool PackedTexture::holdsHeight() const
{
    return std::ranges::any_of(channels, [](const PackedChannel& c) { return c.from == From::Height; });
}

bool PackedTexture::holdsData() const
{
    return holdsHeight() || std::ranges::any_of(channels, [](const PackedChannel& c) { return c.from == From::Baked; });
}

std::optional<PackedChannel> channelOf(const std::string& word)
{
    static const std::vector<PackedChannel> all = allChannels();
    if (const auto found = std::ranges::find(all, word, &PackedChannel::word); found != all.end())
        return *found;
    float value = 0.f;
    const char* const end = word.data() + word.size();
    if (const auto [at, code] = std::from_chars(word.data(), end, value); code == std::errc() && at == end && value >= 0.f && value <= 1.f)
        return PackedChannel{.value = value, .word = word};
    return std::nullopt;
}

std::vector<std::string> channelWords()
{
    std::vector<std::string> words;
    for (PackedChannel& channel : allChannels())
        words.push_back(std::move(channel.word));
    return words;
}

} // namespace relievo
