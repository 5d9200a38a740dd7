// A .glb while it is put together: glTF's JSON and the binary chunk that it refers to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <nlohmann/json.hpp>

namespace relievo {

using GlbJson = nlohmann::ordered_json;

class GlbFile {
public:
    GlbJson json = GlbJson::object(); // without "buffers" and "extensionsUsed", which bytes() adds

    // Appends to the binary chunk, aligned to four bytes, and returns its buffer view. target: glTF's number for what it is used as.
    std::size_t addView(const void* data, std::size_t bytes, int target = 0);

    // componentType: glTF's number. type: "SCALAR", "VEC2" ...
    std::size_t addAccessor(std::size_t view, std::size_t count, int componentType, const char* type);

    // A texture of sampler 0.
    std::size_t addTexture(const std::vector<std::byte>& png, const std::string& name);

    void use(const char* extension);

    // The whole file. An error, of `where`, when it would be larger than a .glb can be.
    Expected<std::vector<std::byte>> bytes(const std::string& where);

    // The same as two: the text of a .gltf that names `binaryFile`, and what is to be in that.
    std::string text(const std::string& binaryFile);
    const std::vector<std::byte>& binary() const { return m_binary; }

private:
    void close(); // nothing is added any more

    std::vector<std::byte> m_binary;
    std::vector<std::string> m_extensions;
};

} // namespace relievo
