// Small files that cost gigabytes or minutes: the image helper takes as much as their pixels can need, and says so.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/process_client.h"
#include "tests/core/image/image_support.h"
#include <csignal>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

using namespace relievo;
using namespace relievo::test;

namespace {
std::string number(std::uint32_t value, int bytes, bool bigEndian)
{
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += char(value >> 8 * (bigEndian ? bytes - 1 - i : i));
    return text;
}
std::string big(std::uint32_t value, int bytes = 4)
{
    return number(value, bytes, true);
}
std::string little(std::uint32_t value)
{
    return number(value, 4, false);
}

// Chunks of PNG, the last of which promises a gigabyte.
std::string pngWithAHugeChunk()
{
    const std::string size = "IHDR" + big(1) + big(1) + std::string("\x08\0\0\0\0", 5);
    std::uint32_t crc = ~0u; // of the first chunk; nobody comes to the second one's
    for (const char c : size) {
        crc ^= std::uint32_t(static_cast<unsigned char>(c));
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return "\x89PNG\r\n\x1a\n" + big(13) + size + big(~crc) + big(0x3fffff73) + "sPLT" + std::string(40, 'x');
}

std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value)
{
    return name + '\0' + type + '\0' + little(std::uint32_t(value.size())) + value;
}

// One pixel of one float channel in a display window of `side` pixels; `more` stands in the header.
std::string exr(int side, const std::string& more)
{
    const std::string zero = little(0), one = little(0x3f800000), last = little(std::uint32_t(side - 1));
    std::string head = std::string("\x76\x2f\x31\x01\x02\0\0\0", 8)
        + exrAttribute("channels", "chlist", std::string("Y\0", 2) + little(2) + zero + little(1) + little(1) + '\0')
        + exrAttribute("compression", "compression", std::string(1, '\0')) + exrAttribute("dataWindow", "box2i", zero + zero + zero + zero)
        + exrAttribute("displayWindow", "box2i", zero + zero + last + last) + exrAttribute("lineOrder", "lineOrder", std::string(1, '\0'))
        + exrAttribute("pixelAspectRatio", "float", one) + exrAttribute("screenWindowCenter", "v2f", zero + zero)
        + exrAttribute("screenWindowWidth", "float", one) + more + '\0';
    const auto pixels = std::uint32_t(head.size() + 8);
    return head + little(pixels) + zero + zero + little(4) + little(0x3f000000);
}

std::string psdWithHugeResources()
{
    return "8BPS" + big(1, 2) + std::string(6, '\0') + big(3, 2) + big(1) + big(1) + big(8, 2) + big(3, 2) + big(0x7fffff00)
        + std::string(20, '\0');
}

// MiB that the running helper has held at most.
long helperPeak()
{
    std::istringstream status(readAll("/proc/" + std::to_string(imageHelperId()) + "/status"));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return std::stol(line.substr(6)) >> 10;
    return 0;
}

void endHelper()
{
    if (imageHelperId() > 0)
        ::kill(imageHelperId(), SIGKILL); // the next request starts another
}
} // namespace

TEST(ImageBudget, TinyFilesTakeLittleMemory)
{
    const TemporaryFolder folder;
    endHelper();
    ASSERT_TRUE(writeImage(folder / "good.png", noiseImage(8, 8, 1, PixelType::U8)));
    const std::pair<const char*, std::string> files[] = {{"chunk.png", pngWithAHugeChunk()},
        {"attribute.exr", exr(1, std::string("x\0string\0", 9) + little(0x7fffff00) + "abc")}, {"resources.psd", psdWithHugeResources()}};
    for (const auto& [name, bytes] : files) {
        writeAll(folder / name, bytes);
        EXPECT_LT(bytes.size(), 400u);
        const auto read = readImage(folder / name);
        ASSERT_FALSE(read) << name;
        EXPECT_EQ(read.error().where, (folder / name).string());
        ASSERT_TRUE(readImage(folder / "good.png"));
#ifndef __SANITIZE_ADDRESS__ // whose memory cannot be bounded so
        EXPECT_LT(helperPeak(), 600) << name;
#endif
    }
}

#ifndef __SANITIZE_ADDRESS__
TEST(ImageBudget, WhatItIsRefusedForIsTold)
{
    const TemporaryFolder folder;
    writeAll(folder / "a.exr", exr(1, std::string("x\0string\0", 9) + little(0x7fffff00) + "abc"));
    const auto read = readImage(folder / "a.exr");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("more memory than one of its size may take"), std::string::npos) << read.error().what;
}
#endif

TEST(ImageBudget, AWindowFarLargerThanItsPixelsIsNotFilled)
{
    const TemporaryFolder folder;
    writeAll(folder / "far.exr", exr(16384, ""));
    const auto far = readImage(folder / "far.exr");
    ASSERT_TRUE(far) << message(far.error());
    EXPECT_EQ(far->image.texelCount(), 1u);
    EXPECT_TRUE(tells(far->warnings, "data-window"));
    writeAll(folder / "near.exr", exr(64, ""));
    const auto near = readImage(folder / "near.exr");
    ASSERT_TRUE(near) << message(near.error());
    EXPECT_EQ(near->image.width, 64);
}

// A helper that has ended itself for time is no crash, and no other is asked the same.
TEST(ImageBudget, OutOfTimeIsTold)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "good.png", noiseImage(8, 8, 1, PixelType::U8)));
    writeAll(
        folder / "helper", "#!/bin/sh\nhead -c 8 > /dev/null\necho >> \"$0.runs\"\nexit " + std::to_string(imageio::kOutOfTime) + "\n");
    std::filesystem::permissions(folder / "helper", std::filesystem::perms::owner_all);
    const std::string before = std::getenv("RELIEVO_IMAGEIO") ? std::getenv("RELIEVO_IMAGEIO") : "";
    endHelper();
    ::setenv("RELIEVO_IMAGEIO", (folder / "helper").c_str(), 1);
    const auto read = readImage(folder / "good.png");
    if (before.empty())
        ::unsetenv("RELIEVO_IMAGEIO");
    else
        ::setenv("RELIEVO_IMAGEIO", before.c_str(), 1);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("far longer than an image of its size"), std::string::npos) << read.error().what;
    EXPECT_EQ(readAll(folder / "helper.runs"), "\n");
    EXPECT_TRUE(readImage(folder / "good.png"));
}
