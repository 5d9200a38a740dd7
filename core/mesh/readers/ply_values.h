// The data of a PLY file, text and binary of either byte order.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/ply_header.h"

namespace relievo {

// The numbers of the file one after the other, never beyond its end.
class PlyValues {
public:
    PlyValues(std::string_view data, PlyHeader::Format format)
        : m_text(format == PlyHeader::Format::Text ? data : std::string_view())
        , m_bytes(data)
        , m_format(format)
    {
    }

    bool failed() const { return m_failed; }
    std::size_t cutNumbers() const { return m_cut; }
    // No number takes less than a byte.
    std::size_t left() const { return m_format == PlyHeader::Format::Text ? m_text.rest().size() : m_bytes.size(); }

    // Text: one element a line. What a writer adds at its end (there are some that do) is passed over.
    void endElement() { m_text.line(); }

    double next(PlyType type);

private:
    TextCursor m_text;
    std::string_view m_bytes;
    PlyHeader::Format m_format;
    bool m_failed = false;
    std::size_t m_cut = 0; // numbers of the text with something behind them
};

} // namespace relievo
