// URIs of glTF files: names of files beside them, or the data themselves.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace relievo {

// "a%20b" is "a b".
std::string percentDecoded(const std::string& uri);

// Every byte as %XX: a name that tinygltf, which decodes it again, finds whatever is in it.
std::string percentEncoded(const std::string& name);

// Base64 data under the one media type that tinygltf knows for everything; nothing for any other URI.
std::optional<std::string> octetsOf(const std::string& uri);

} // namespace relievo
