// Numbers as PLY files write them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/ply_values.h"
#include <algorithm>
#include <bit>
#include <cstring>

namespace relievo {

namespace {
constexpr std::size_t kTypeBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};

template <class T> double as(const char* raw)
{
    T value;
    std::memcpy(&value, raw, sizeof value);
    return double(value);
}

double decoded(const char* raw, PlyType type)
{
    switch (type) {
    case PlyType::I8:
        return as<std::int8_t>(raw);
    case PlyType::U8:
        return as<std::uint8_t>(raw);
    case PlyType::I16:
        return as<std::int16_t>(raw);
    case PlyType::U16:
        return as<std::uint16_t>(raw);
    case PlyType::I32:
        return as<std::int32_t>(raw);
    case PlyType::U32:
        return as<std::uint32_t>(raw);
    case PlyType::F32:
        return as<float>(raw);
    case PlyType::F64:
        break;
    }
    return as<double>(raw);
}
} // namespace

double PlyValues::next(PlyType type)
{
    if (m_format == PlyHeader::Format::Text) {
        const std::string_view word = m_text.word();
        m_failed |= word.empty();
        if (type >= PlyType::F32)
            return doubleOf(word, m_cut);
        const std::optional<long long> whole = integerOf(word);
        return whole ? double(*whole) : double(floatOf(word)); // some writers print counts as 3.0
    }
    const std::size_t size = kTypeBytes[std::size_t(type)];
    if (m_bytes.size() < size) {
        m_failed = true;
        m_bytes = {};
        return 0;
    }
    char raw[8] = {};
    std::copy_n(m_bytes.data(), size, raw);
    m_bytes.remove_prefix(size);
    if ((m_format == PlyHeader::Format::Big) != (std::endian::native == std::endian::big))
        std::reverse(raw, raw + size);
    return decoded(raw, type);
}

} // namespace relievo
