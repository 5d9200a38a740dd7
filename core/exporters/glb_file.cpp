// The layout of a .glb file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/glb_file.h"
#include <algorithm>

namespace relievo {

namespace {
void put(std::vector<std::byte>& out, std::uint32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(std::byte(value >> shift & 0xffu));
}

// A file's name as a URI, RFC 3986: unreserved characters stay.
std::string uriOf(const std::string& name)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF", kPlain = "-._~";
    std::string uri;
    for (const char c : name)
        if ((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || kPlain.find(c) != std::string_view::npos)
            uri += c;
        else
            uri.append({'%', kDigits[std::size_t(std::uint8_t(c)) >> 4], kDigits[std::size_t(std::uint8_t(c)) & 15]});
    return uri;
}
} // namespace

std::size_t GlbFile::addView(const void* data, std::size_t bytes, int target)
{
    m_binary.resize((m_binary.size() + 3) / 4 * 4);
    GlbJson view = {{"buffer", 0}, {"byteOffset", m_binary.size()}, {"byteLength", bytes}};
    if (target != 0)
        view["target"] = target;
    const auto* first = static_cast<const std::byte*>(data);
    m_binary.insert(m_binary.end(), first, first + bytes);
    json["bufferViews"].push_back(std::move(view));
    return json["bufferViews"].size() - 1;
}

std::size_t GlbFile::addAccessor(std::size_t view, std::size_t count, int componentType, const char* type)
{
    json["accessors"].push_back({{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return json["accessors"].size() - 1;
}

std::size_t GlbFile::addTexture(const std::vector<std::byte>& png, const std::string& name)
{
    json["images"].push_back({{"name", name}, {"mimeType", "image/png"}, {"bufferView", addView(png.data(), png.size())}});
    json["textures"].push_back({{"sampler", 0}, {"source", json["images"].size() - 1}});
    return json["textures"].size() - 1;
}

void GlbFile::use(const char* extension)
{
    if (std::ranges::find(m_extensions, extension) == m_extensions.end())
        m_extensions.push_back(extension);
}

void GlbFile::close()
{
    if (!m_extensions.empty())
        json["extensionsUsed"] = m_extensions;
    m_binary.resize((m_binary.size() + 3) / 4 * 4);
    json["buffers"] = GlbJson::array({{{"byteLength", m_binary.size()}}});
}

std::string GlbFile::text(const std::string& binaryFile)
{
    close();
    json["buffers"][0]["uri"] = uriOf(binaryFile);
    return json.dump(1, ' ', false, GlbJson::error_handler_t::replace) + '\n';
}

Expected<std::vector<std::byte>> GlbFile::bytes(const std::string& where)
{
    close();
    std::string text = json.dump(-1, ' ', false, GlbJson::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + 8 + m_binary.size();
    if (total > 0xffffffffu)
        return failure(where, "a .glb cannot hold more than 4 GiB", "Export smaller textures");
    std::vector<std::byte> file;
    file.reserve(total);
    for (const std::uint32_t word : {0x46546C67u, 2u, std::uint32_t(total), std::uint32_t(text.size()), 0x4E4F534Au})
        put(file, word);
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    file.insert(file.end(), first, first + text.size());
    put(file, std::uint32_t(m_binary.size()));
    put(file, 0x004E4942u);
    file.insert(file.end(), m_binary.begin(), m_binary.end());
    return file;
}

} // namespace relievo
