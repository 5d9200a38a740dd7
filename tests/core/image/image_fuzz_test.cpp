// Mutated image files: a picture or an error, never a crash of ours, never a hang.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/file_names.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

TEST(ImageFuzz, MutatedFilesAreAnsweredWithinSize)
{
    const TemporaryFolder folder;
    std::mt19937 random(7);
    const int rounds = fuzzRounds(25);
    for (const char* suffix : {"png", "tif", "exr", "tga", "bmp", "hdr", "jpg"}) {
        const auto file = folder / (std::string("x.") + suffix);
        ASSERT_TRUE(writeImage(file, noiseImage(13, 11, 3, PixelType::U8)));
        const std::string good = readAll(file);
        for (int round = 0; round < rounds; ++round) {
            std::string bytes = good;
            for (int hits = 0; hits < 1 + round % 4; ++hits) // headers matter most
                bytes[random() % std::min<std::size_t>(bytes.size(), round % 2 ? 64 : bytes.size())] = char(random());
            writeAll(file, bytes);
            const auto read = readImage(file);
            if (read)
                EXPECT_EQ(
                    read->image.data.size(), read->image.texelCount() * std::size_t(read->image.channels) * bytesOf(read->image.type));
            else
                EXPECT_EQ(read.error().where, file.string());
        }
    }
}

TEST(ImageFuzz, AnyFileNameIsParsed)
{
    constexpr std::string_view kPieces[]
        = {"normal", "_", "-", "Height", "4K", "16", "bit", " ", ".", "n", "GL", "Color", "\xff\xfe", "(", "x", "0", "arm", "NORM"};
    std::mt19937 random(11);
    const int rounds = fuzzRounds(20000);
    for (int round = 0; round < rounds; ++round) {
        std::string name;
        for (unsigned long count = random() % 7; count > 0; --count)
            name += random() % 8 ? std::string(kPieces[random() % std::size(kPieces)]) : std::string(1, char(random()));
        const NameGuess guess = guessFromName(name);
        EXPECT_LE(guess.stem.size(), name.size() + 8);
        EXPECT_LE(guess.roles.size(), 3u);
    }
}
