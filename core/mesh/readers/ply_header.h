// The header of a PLY file: what its data are.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

enum class PlyType { I8, U8, I16, U16, I32, U32, F32, F64 };
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::F32;
    std::optional<PlyType> countType; // of a list
};
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};
struct PlyHeader {
    enum class Format { Text, Little, Big } format = Format::Text;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0; // where the data begin
};

// text: the whole file, of the name `where`.
Expected<PlyHeader> parsePlyHeader(std::string_view text, const std::string& where);

} // namespace relievo
