// Asking a .gltf for its buffers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/buffers.h"
#include "core/gltf/gltf_uri.h"
#include "core/ground/file.h"
#include "core/ground/json_depth.h"
#include "core/ground/text.h"
#include <nlohmann/json.hpp>

namespace relievo {

std::vector<std::filesystem::path> buffersBeside(const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> files;
    const Expected<std::string> text = lowerSuffix(file) == ".gltf" ? readText(file) : std::string();
    if (!text || isNestedTooDeep(*text))
        return files;
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    const auto buffers = json.is_object() ? json.find("buffers") : json.end();
    if (buffers == json.end() || !buffers->is_array())
        return files;
    for (const auto& buffer : *buffers)
        if (buffer.is_object() && buffer.contains("uri") && buffer["uri"].is_string())
            if (const std::string uri = buffer["uri"]; !uri.starts_with("data:"))
                files.push_back(file.parent_path() / percentDecoded(uri));
    return files;
}

} // namespace relievo
