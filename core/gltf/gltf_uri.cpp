// Percent signs and base64 in URIs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_uri.h"
#include "core/ground/text.h"
#include <algorithm>
#include <charconv>
#include <cstdio>

namespace relievo {

std::string percentDecoded(const std::string& uri)
{
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        int byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += char(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

std::string percentEncoded(const std::string& name)
{
    std::string uri;
    for (const char c : name) {
        char digits[4];
        std::snprintf(digits, sizeof digits, "%%%02X", unsigned(static_cast<unsigned char>(c)));
        uri += digits;
    }
    return uri;
}

std::optional<std::string> octetsOf(const std::string& uri)
{
    const std::size_t comma = std::min(uri.find(','), uri.size());
    const std::string head = lowered(std::string_view(uri).substr(0, comma));
    if (!head.starts_with("data:") || !head.ends_with(";base64"))
        return std::nullopt;
    return "data:application/octet-stream;base64" + uri.substr(comma);
}

} // namespace relievo
