// Ranking candidates.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/set_candidates.h"
#include <algorithm>
#include <tuple>

namespace relievo {
namespace {
bool isLossy(const std::filesystem::path& file)
{
    const std::string suffix = file.extension().string();
    return suffix.size() >= 2 && (suffix[1] == 'j' || suffix[1] == 'J');
}

// Smaller is better. Depth of bits outweighs size only where steps show: in heights.
auto rankOf(const Candidate& candidate, MapKind kind)
{
    const Convention convention = candidate.guess.convention;
    const int style = convention == Convention::DX ? 2 : convention == Convention::GL ? 0 : 1;
    const double texels = double(candidate.info.width) * candidate.info.height;
    const bool shallow = candidate.info.storedBits <= 8;
    return std::tuple(!candidate.chosenByUser, candidate.guess.rank == kNoKindRank, !candidate.likeChosen,
        kind == MapKind::Height && shallow, style, -texels, shallow, candidate.guess.packing != Packing::None, candidate.guess.rank,
        isLossy(candidate.file), candidate.file.filename().string());
}

std::vector<MapRole> packedRoles(const NameGuess& guess, int channels)
{
    std::vector<MapRole> roles = guess.roles;
    std::erase_if(roles, [channels](const MapRole& role) { return int(role.channel) >= channels; });
    return roles;
}
} // namespace

std::vector<MapRole> rolesByChannels(const NameGuess& guess, int channels)
{
    switch (guess.packing) {
    case Packing::None:
        return guess.roles;
    case Packing::Channels:
        return channels >= 3 ? packedRoles(guess, channels) : std::vector<MapRole>();
    case Packing::ColorAndAlpha:
        return channels >= 3 ? std::vector<MapRole>{guess.roles.front(), channels == 4 ? guess.roles.back() : guess.plain}
                             : std::vector<MapRole>{guess.plain};
    case Packing::Relief:
        break;
    }
    return channels == 4 ? guess.roles : std::vector<MapRole>{channels <= 2 ? guess.plain : guess.roles.front()};
}

std::vector<Choice> chooseMaps(const std::vector<Candidate>& candidates)
{
    std::vector<Choice> choices;
    for (const MapKindRow& row : kMapKinds) {
        std::optional<Choice> best;
        for (const Candidate& candidate : candidates)
            for (const MapRole& role : candidate.roles)
                if (role.kind == row.kind && (!best || rankOf(candidate, row.kind) < rankOf(*best->candidate, row.kind)))
                    best = Choice{role, &candidate};
        if (best)
            choices.push_back(*best);
    }
    return choices;
}

} // namespace relievo
