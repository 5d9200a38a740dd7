// A texture set as `info --json` prints it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/texture_set.h"
#include <nlohmann/json.hpp>

namespace relievo {
namespace {
nlohmann::ordered_json jsonOf(const FoundMap& map, const std::filesystem::path& folder)
{
    return {{"kind", row(map.kind).key}, {"file", map.file.lexically_relative(folder).string()}, {"channel", wordOf(map.channel)},
        {"width", map.info.width}, {"height", map.info.height}, {"bits", map.info.storedBits}, {"convention", wordOf(map.convention)},
        {"min", map.min}, {"max", map.max}};
}
} // namespace

std::string textureSetJson(const TextureSet& set)
{
    nlohmann::ordered_json json;
    json["name"] = set.name;
    json["maps"] = nlohmann::ordered_json::array();
    for (const FoundMap& map : set.maps)
        json["maps"].push_back(jsonOf(map, set.folder));
    json["warnings"] = nlohmann::ordered_json::array();
    for (const Warning& warning : set.warnings)
        json["warnings"].push_back({{"code", warning.code}, {"text", warning.text}});
    // File names may hold any bytes: those that are no UTF-8 are shown as a replacement sign.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace relievo
