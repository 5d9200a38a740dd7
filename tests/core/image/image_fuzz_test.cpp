// Mutated image files: a picture or an error, never a crash of ours, never a hang.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/file_names.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/image/image_support.h"
#include "tests/core/image/odd_files.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
// Sound files of each format, by name.
std::vector<std::pair<std::string, std::string>> soundFiles(const TemporaryFolder& folder)
{
    std::vector<std::pair<std::string, std::string>> files;
    for (const char* suffix : {"png", "tif", "exr", "tga", "bmp", "hdr", "jpg"}) {
        const std::string name = std::string("x.") + suffix;
        EXPECT_TRUE(writeImage(folder / name, noiseImage(13, 11, 3, PixelType::U8)));
        files.emplace_back(name, readAll(folder / name));
    }
    const Image layer = noiseImage(13, 11, 3, PixelType::F32);
    EXPECT_TRUE(writeLayers(folder / "layers.exr", std::vector<ImageLayer>{{"one", layer}, {"height", layer}}));
    files.emplace_back("layers.exr", readAll(folder / "layers.exr"));
    const std::string pixels(16 * 16 * 2, '\x5a');
    files.emplace_back("plain.dds", dds(16, 16, 56, pixels));
    files.emplace_back("blocks.dds", dds(16, 16, 84, pixels));
    files.emplace_back("old.dds", oldDds(16, 16, 0x20000, 0, 16, {0xffff}, pixels));
    files.emplace_back("dem.tif",
        tiff(16, 16, 16, 2, 0, pixels,
            {doublesTag(33550, {10, 10, 0}), doublesTag(33922, {0, 0, 0, 1, 2, 3}), shortsTag(34735, {1, 1, 0, 1, 1024, 0, 1, 1}),
                {42113, 2, 6, std::string("-9999\0", 6)}}));
    return files;
}
} // namespace

TEST(ImageFuzz, MutatedFilesAreAnsweredWithinSize)
{
    const TemporaryFolder folder;
    std::mt19937 random(7);
    const int rounds = fuzzRounds(25);
    for (const auto& [name, good] : soundFiles(folder)) {
        const auto file = folder / name;
        writeAll(file, good);
        ASSERT_TRUE(readImage(file)) << name;
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
