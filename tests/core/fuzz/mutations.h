// Changing a sound text or file in a few places.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace relievo::test {

inline std::size_t below(std::mt19937& random, std::size_t n)
{
    return n == 0 ? 0 : std::size_t(random()) % n;
}

// What readers of numbers and of JSON stumble over.
inline constexpr std::string_view kOddWords[] = {"1e999", "-1e999", "-0", "0", "1e-400", "nan", "inf", "-inf", "99999999999", "-2147483648",
    "18446744073709551616", "0.1", "1", "null", "true", "false", "{}", "[]", "[", "]", "{", "}", "\"", "\\", ",", ":", "[0,0,0]", "[1,2]",
    "\"\"", "\"\\u0000\"", "\"\\u001b[2J\"", "\"\\ud800\"", "\xff", "\xc2\x9b", "\n", "\r\n", "..", "/", "#", "sample:", "../../x"};

// One to six edits: bytes, bits, cuts, repeats, words of `words` put in or in place of others, and pieces of `other`.
inline std::string mutated(
    std::string bytes, const std::string& other, std::mt19937& random, std::span<const std::string_view> words = kOddWords)
{
    for (std::size_t edits = 1 + below(random, 6); edits > 0 && !bytes.empty(); --edits) {
        const std::size_t at = below(random, bytes.size()), length = std::min(below(random, 60), bytes.size() - at);
        const std::string_view word = words[below(random, words.size())];
        switch (below(random, 9)) {
        case 0:
            bytes[at] = char(random());
            break;
        case 1:
            bytes[at] = char(bytes[at] ^ char(1u << below(random, 8)));
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, length));
            break;
        case 4:
            bytes.insert(at, word);
            break;
        case 5:
            bytes.replace(at, std::min(length, word.size()), word);
            break;
        case 6: {
            const std::size_t from = below(random, other.size());
            bytes.replace(at, length, other.substr(from, below(random, 80)));
            break;
        }
        case 7: { // the next number becomes a word
            const std::size_t number = bytes.find_first_of("0123456789", at);
            const std::size_t end = std::min(bytes.find_first_not_of("0123456789.eE+-", std::min(number, bytes.size())), bytes.size());
            if (number != bytes.npos)
                bytes.replace(number, end - number, word);
            break;
        }
        default:
            if (below(random, 8) == 0)
                bytes.resize(at);
        }
    }
    return bytes;
}

// Nothing that a terminal would obey.
inline bool isPlain(std::string_view text)
{
    return std::ranges::none_of(text, [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; });
}

} // namespace relievo::test
