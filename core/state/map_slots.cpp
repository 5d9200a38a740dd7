// Looking up map kinds.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/map_slots.h"
#include <algorithm>

namespace relievo {

std::optional<MapKind> findMapKind(std::string_view key)
{
    const auto found = std::ranges::find(kMapKinds, key, &MapKindRow::key);
    return found == kMapKinds.end() ? std::nullopt : std::optional(found->kind);
}

std::string keysOf(EnumSet<MapKind> kinds)
{
    std::string keys;
    for (const MapKindRow& row : kMapKinds)
        if (kinds.contains(row.kind))
            keys += (keys.empty() ? "" : " ") + std::string(row.key);
    return keys;
}

} // namespace relievo
