// Members of glTF extensions, which may be missing or of another type.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <tiny_gltf.h>

namespace relievo {

inline const tinygltf::Value& member(const tinygltf::Value& object, const char* key)
{
    static const tinygltf::Value none;
    return object.IsObject() && object.Has(key) ? object.Get(key) : none;
}

inline double numberOf(const tinygltf::Value& value, double otherwise)
{
    return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

inline int indexOf(const tinygltf::Value& value, int otherwise)
{
    const double number = numberOf(value, double(otherwise));
    return number >= -1.0 && number < 1e9 ? int(number) : otherwise;
}

inline std::string textOf(const tinygltf::Value& value)
{
    return value.IsString() ? value.Get<std::string>() : std::string();
}

} // namespace relievo
