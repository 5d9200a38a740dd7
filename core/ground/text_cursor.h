// Reading numbers and words from a text file in memory, without locale and without leaving it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

// Text of an OBJ or MTL file as it is parsed: UTF-16 (with its mark) becomes UTF-8, or its ASCII part where it is damaged; UTF-8's mark is
// removed.
std::string plainText(std::string text);

// Words of a text, separated by spaces and tabs (and line ends when the text holds them).
class TextCursor {
public:
    explicit TextCursor(std::string_view text) : m_rest(text) { }

    // The next word, "" at the end.
    std::string_view word()
    {
        const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; };
        std::size_t from = 0;
        while (from < m_rest.size() && isSpace(m_rest[from]))
            ++from;
        std::size_t to = from;
        while (to < m_rest.size() && !isSpace(m_rest[to]))
            ++to;
        const std::string_view found = m_rest.substr(from, to - from);
        m_rest.remove_prefix(to);
        return found;
    }

    std::string_view rest() const { return m_rest; }

    // The next line without its end; nothing after the last one.
    std::optional<std::string_view> line()
    {
        if (m_rest.empty())
            return std::nullopt;
        const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
        const std::string_view found = m_rest.substr(0, end);
        const bool pair = end + 1 < m_rest.size() && m_rest[end] == '\r' && m_rest[end + 1] == '\n';
        m_rest.remove_prefix(std::min(end + (pair ? 2 : 1), m_rest.size()));
        return found;
    }

private:
    std::string_view m_rest;
};

// The number that a word begins with: "1.5", "+2.", "3.1e2", "nan"; what follows it is ignored but counted (decimal commas). NaN when
// there is none, or none that a float can hold.
inline double doubleOf(std::string_view word, std::size_t& cut)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    cut += code == std::errc() && end != word.data() + word.size();
    if (code == std::errc::result_out_of_range) // too small or too large for a double
        return word.find("e-") != word.npos || word.find("E-") != word.npos ? 0.0 : std::numeric_limits<double>::infinity();
    return code == std::errc() && (value < 3e38 && value > -3e38) ? value : std::numeric_limits<double>::quiet_NaN();
}

inline float floatOf(std::string_view word, std::size_t& cut)
{
    return float(doubleOf(word, cut));
}

inline float floatOf(std::string_view word)
{
    std::size_t cut = 0;
    return floatOf(word, cut);
}

// A whole number that fills the word; nothing for anything else.
inline std::optional<long long> integerOf(std::string_view word)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    long long value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    return code == std::errc() && end == word.data() + word.size() && !word.empty() ? std::optional(value) : std::nullopt;
}

} // namespace relievo
