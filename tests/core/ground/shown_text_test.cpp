// Foreign text in messages: shortened, and nothing in it that a terminal obeys.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/error.h"
#include "core/ground/json_depth.h"
#include "core/ground/shown_text.h"
#include <gtest/gtest.h>

using namespace relievo;

TEST(ShownText, EscapesWhatTerminalsObey)
{
    EXPECT_EQ(escaped("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(escaped(std::string_view("\x1B[31mred\0\x7F", 10)), "\\x1B[31mred\\x00\\x7F");
    EXPECT_EQ(escaped("\xC2\x9B"
                      "2J"),
        "\\u{9B}2J");
    EXPECT_EQ(escaped("\u202Egnp.exe\u2066\u2028"), "\\u{202E}gnp.exe\\u{2066}\\u{2028}");
    EXPECT_EQ(escaped("Mauer Gr\u00f6\u00dfe \u77f3\u57a3 \U0001F9F1"), "Mauer Gr\u00f6\u00dfe \u77f3\u57a3 \U0001F9F1");
}

TEST(ShownText, ShowsBytesThatAreNoUtf8)
{
    EXPECT_EQ(escaped("Gr\xF6\xDF"), "Gr\\xF6\\xDF"); // cp1252
    EXPECT_EQ(escaped("\xC0\xAF"), "\\xC0\\xAF"); // a slash, written too long
    EXPECT_EQ(escaped("\xED\xA0\x80"), "\\xED\\xA0\\x80"); // half of a pair
    EXPECT_EQ(escaped("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80"); // past the last character
    EXPECT_EQ(escaped("x\xE7\x9F"), "x\\xE7\\x9F"); // cut
}

TEST(ShownText, CutsBetweenCharacters)
{
    std::string longName;
    for (int i = 0; i < 400; ++i)
        longName += "\u77f3";
    const std::string name = shownName(longName);
    EXPECT_LE(name.size(), 80u);
    EXPECT_TRUE(name.ends_with("\u77f3..."));
    EXPECT_EQ(shownName("wall"), "wall");
    for (std::size_t most = 20; most < 24; ++most)
        EXPECT_EQ(shownText(longName, most).find('\\'), std::string::npos);
}

TEST(ShownText, AMessageKeepsItsCure)
{
    const std::string text = message({"\"" + std::string(1 << 20, 'x') + "\" is not there", "p.relievo\n", "Check the path"});
    EXPECT_LT(text.size(), 2000u);
    EXPECT_TRUE(text.starts_with("p.relievo\\n: \"xxx"));
    EXPECT_TRUE(text.ends_with("xxx\" is not there. Check the path."));
}

TEST(JsonDepth, CountsBracketsOutsideOfStrings)
{
    const auto nested = [](int depth) { return std::string(std::size_t(depth), '[') + std::string(std::size_t(depth), ']'); };
    EXPECT_FALSE(isNestedTooDeep(nested(256)));
    EXPECT_TRUE(isNestedTooDeep(nested(257)));
    EXPECT_TRUE(isNestedTooDeep("{\"a\":" + nested(60000) + ",\"b\":1}"));
    EXPECT_FALSE(isNestedTooDeep("[\"" + std::string(1000, '[') + "\\\"" + std::string(1000, '{') + "\"]"));
    std::string side = "[";
    for (int i = 0; i < 1000; ++i)
        side += "[],{},";
    EXPECT_FALSE(isNestedTooDeep(side + "1]"));
}
