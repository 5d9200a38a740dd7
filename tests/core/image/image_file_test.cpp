// Image files: every format and depth there and back, bad files refused in words, and a helper that may die.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "core/image/files/process_client.h"
#include "tests/core/image/image_support.h"
#include <csignal>
#include <gtest/gtest.h>
#include <thread>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
struct RoundTrip {
    const char* suffix;
    PixelType type, back;
    int channels, channelsBack;
    bool exact;
};

std::string tripName(const testing::TestParamInfo<RoundTrip>& info)
{
    static constexpr const char* kTypes[] = {"U8", "U16", "F32"};
    return std::string(info.param.suffix) + kTypes[int(info.param.type)] + std::to_string(info.param.channels);
}

std::vector<RoundTrip> losslessTrips()
{
    std::vector<RoundTrip> trips;
    for (int channels = 1; channels <= 4; ++channels) {
        for (PixelType type : {PixelType::U8, PixelType::U16}) {
            trips.push_back({"png", type, type, channels, channels, true});
            trips.push_back({"tif", type, type, channels, channels, true});
        }
        trips.push_back({"tif", PixelType::F32, PixelType::F32, channels, channels, true});
        trips.push_back({"exr", PixelType::F32, PixelType::F32, channels, channels, true});
    }
    return trips;
}

class ImageRoundTrip : public testing::TestWithParam<RoundTrip> { };

TEST_P(ImageRoundTrip, KeepsSizeTypeAndValues)
{
    const RoundTrip& trip = GetParam();
    const TemporaryFolder folder;
    const Image image = noiseImage(37, 23, trip.channels, trip.type);
    const fs::path file = folder / (std::string("x.") + trip.suffix);
    const auto written = writeImage(file, image);
    ASSERT_TRUE(written) << message(written.error());
    const auto read = readImage(file);
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->image.width, 37);
    EXPECT_EQ(read->image.height, 23);
    EXPECT_EQ(read->image.channels, trip.channelsBack);
    EXPECT_EQ(read->image.type, trip.back);
    EXPECT_EQ(read->image.storedBits, int(bytesOf(trip.back)) * 8);
    EXPECT_EQ(read->image.storedFloat, trip.back == PixelType::F32);
    EXPECT_TRUE(read->warnings.empty());
    if (trip.exact) {
        EXPECT_EQ(read->image.data, image.data);
    }
    const auto info = readImageInfo(file);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->width, 37);
    EXPECT_EQ(info->channels, trip.channelsBack);
}
INSTANTIATE_TEST_SUITE_P(Lossless, ImageRoundTrip, testing::ValuesIn(losslessTrips()), tripName);
INSTANTIATE_TEST_SUITE_P(Others, ImageRoundTrip,
    testing::Values(RoundTrip{"tga", PixelType::U8, PixelType::U8, 1, 1, true}, RoundTrip{"tga", PixelType::U8, PixelType::U8, 3, 3, true},
        RoundTrip{"tga", PixelType::U8, PixelType::U8, 4, 4, true}, RoundTrip{"tga", PixelType::U16, PixelType::U8, 3, 3, false},
        RoundTrip{"bmp", PixelType::U8, PixelType::U8, 3, 3, true}, RoundTrip{"bmp", PixelType::U8, PixelType::U8, 2, 4, false},
        RoundTrip{"jpg", PixelType::U8, PixelType::U8, 3, 3, false}, RoundTrip{"jpg", PixelType::U16, PixelType::U8, 1, 1, false},
        RoundTrip{"jpg", PixelType::F32, PixelType::U8, 4, 3, false}, RoundTrip{"png", PixelType::F32, PixelType::U16, 3, 3, false},
        RoundTrip{"hdr", PixelType::F32, PixelType::F32, 3, 3, false}, RoundTrip{"hdr", PixelType::U16, PixelType::F32, 1, 3, false},
        RoundTrip{"exr", PixelType::U16, PixelType::F32, 1, 1, false}),
    tripName);

TEST(ImageFile, RoundsFloatsToSixteenBits)
{
    const TemporaryFolder folder;
    const Image image = noiseImage(16, 16, 1, PixelType::F32);
    ASSERT_TRUE(writeImage(folder / "x.png", image));
    const auto read = readImage(folder / "x.png");
    ASSERT_TRUE(read);
    for (int i = 0; i < 256; ++i)
        EXPECT_NEAR(read->image.value(i % 16, i / 16, 0), image.value(i % 16, i / 16, 0), 0.51 / 65535);
}

// Alpha holds heights: a colour under alpha 0 must come back untouched.
TEST(ImageFile, NeverMultipliesColourByAlpha)
{
    const TemporaryFolder folder;
    const Image image = makeImage(8, 8, 4, PixelType::U8, [](int x, int, int c) { return c == 3 ? float(x) / 255.f : 200.f / 255.f; });
    for (const char* name : {"x.png", "x.tif", "x.tga"}) {
        ASSERT_TRUE(writeImage(folder / name, image));
        const auto read = readImage(folder / name);
        ASSERT_TRUE(read) << name;
        EXPECT_EQ(read->image.data, image.data) << name;
    }
}

TEST(ImageFile, OddSizes)
{
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 700), std::pair(700, 1), std::pair(16384, 16), std::pair(3, 16384)}) {
        const Image image = noiseImage(width, height, 1, PixelType::U16);
        ASSERT_TRUE(writeImage(folder / "x.png", image));
        const auto read = readImage(folder / "x.png");
        ASSERT_TRUE(read) << width << " x " << height;
        EXPECT_EQ(read->image.data, image.data) << width << " x " << height;
    }
}

TEST(ImageFile, BoxReducesWhatIsTooWide)
{
    const TemporaryFolder folder;
    const Image image = makeImage(20001, 5, 1, PixelType::U16, [](int x, int y, int) { return float((x + y) % 4) / 4.f; });
    ASSERT_TRUE(writeImage(folder / "x.tif", image));
    const auto read = readImage(folder / "x.tif");
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_TRUE(tells(read->warnings, "reduced"));
    ASSERT_EQ(read->image.width, 10001);
    ASSERT_EQ(read->image.height, 3);
    for (const int x : {0, 77, 9999}) {
        const float mean
            = (image.value(2 * x, 2, 0) + image.value(2 * x + 1, 2, 0) + image.value(2 * x, 3, 0) + image.value(2 * x + 1, 3, 0)) / 4;
        EXPECT_NEAR(read->image.value(x, 1, 0), mean, 1.0 / 65535);
    }
    EXPECT_NEAR(read->image.value(10000, 2, 0), image.value(20000, 4, 0), 1.0 / 65535); // a box of one texel
    const auto info = readImageInfo(folder / "x.tif");
    ASSERT_TRUE(info);
    EXPECT_EQ(info->width, 20001);
}

TEST(ImageFile, LayersAreNamed)
{
    const TemporaryFolder folder;
    const std::vector<ImageLayer> layers
        = {{"shaded", noiseImage(9, 7, 4, PixelType::F32, 1)}, {"depth", noiseImage(9, 7, 1, PixelType::F32, 2)}};
    const auto written = writeLayers(folder / "x.exr", layers);
    ASSERT_TRUE(written) << message(written.error());
    const std::string bytes = readAll(folder / "x.exr");
    EXPECT_NE(bytes.find("depth.Y"), std::string::npos);
    const auto read = readImage(folder / "x.exr");
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->image.data, layers[0].image.data); // the first layer has plain names
    EXPECT_TRUE(tells(read->warnings, "parts"));
}

TEST(ImageFile, LayersOfDifferentSizesAreRefused)
{
    const TemporaryFolder folder;
    const std::vector<ImageLayer> layers = {{"a", noiseImage(9, 7, 4, PixelType::F32)}, {"b", noiseImage(9, 8, 1, PixelType::F32)}};
    EXPECT_FALSE(writeLayers(folder / "x.exr", layers));
    EXPECT_FALSE(fs::exists(folder / "x.exr"));
}

TEST(ImageFile, PngBytesThereAndBack)
{
    const Image image = noiseImage(31, 17, 3, PixelType::U16);
    const auto bytes = encodePng(image, true);
    ASSERT_TRUE(bytes) << message(bytes.error());
    const auto read = readImageBytes(*bytes, "texture 3 of x.glb");
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->image.data, image.data);
    const auto broken = readImageBytes(std::span(*bytes).first(bytes->size() / 2), "texture 3 of x.glb");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().where, "texture 3 of x.glb");
}

TEST(ImageFile, TruncatedFilesAreRefused)
{
    const TemporaryFolder folder;
    for (const char* suffix : {"png", "tif", "exr", "hdr", "tga", "bmp", "jpg"}) {
        const fs::path whole = folder / (std::string("whole.") + suffix), part = folder / (std::string("part.") + suffix);
        ASSERT_TRUE(writeImage(whole, noiseImage(64, 64, 3, PixelType::U8)));
        const std::string bytes = readAll(whole);
        for (const double share : {0.0, 0.3, 0.6, 0.9}) {
            writeAll(part, bytes.substr(0, std::size_t(double(bytes.size()) * share)));
            const auto read = readImage(part);
            ASSERT_FALSE(read) << suffix << " " << share;
            EXPECT_EQ(read.error().where, part.string());
            EXPECT_FALSE(read.error().what.empty());
        }
    }
}

TEST(ImageFile, WordsForTheUsualMistakes)
{
    const TemporaryFolder folder;
    writeAll(folder / "notes.txt", "hello");
    writeAll(folder / "not.png", "hello, this is no picture");
    for (const fs::path& file : {folder / "missing.png", folder.path(), folder / "notes.txt", folder / "not.png"}) {
        const auto read = readImage(file);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().where, file.string());
        EXPECT_FALSE(read.error().hint.empty()) << read.error().what;
        EXPECT_FALSE(readImageInfo(file));
    }
}

TEST(ImageFile, UnwritableOutputLeavesNothing)
{
    const TemporaryFolder folder;
    const Image image = noiseImage(8, 8, 1, PixelType::U8);
    const auto nowhere = writeImage(folder / "no/such/x.png", image);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().where, (folder / "no/such/x.png").string());
    EXPECT_FALSE(writeImage(folder / "x.webp", image));
    EXPECT_FALSE(writeImage(folder / "x", image));
    EXPECT_FALSE(writeImage(folder / "empty.png", Image()));
    EXPECT_TRUE(fs::is_empty(folder.path()));
    ASSERT_TRUE(writeImage(folder / "x.png", image));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(ImageFile, SeveralThreadsReadAtOnce)
{
    const TemporaryFolder folder;
    for (unsigned i = 0; i < 4; ++i)
        ASSERT_TRUE(writeImage(folder / (std::to_string(i) + ".png"), noiseImage(40 + int(i), 30, 3, PixelType::U16, i)));
    std::vector<std::thread> threads;
    std::array<int, 4> good = {};
    for (unsigned i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            for (int round = 0; round < 10; ++round) {
                const auto read = readImage(folder / (std::to_string(i) + ".png"));
                good[i] += read && read->image.data == noiseImage(40 + int(i), 30, 3, PixelType::U16, i).data;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const int count : good)
        EXPECT_EQ(count, 10);
}

TEST(ImageFile, HelperIsKeptAndRespawnedAfterItsDeath)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "x.png", noiseImage(8, 8, 1, PixelType::U8)));
    const int first = imageHelperId();
    ASSERT_GT(first, 0);
    ASSERT_TRUE(readImage(folder / "x.png"));
    EXPECT_EQ(imageHelperId(), first);
    ASSERT_EQ(::kill(first, SIGKILL), 0);
    ASSERT_TRUE(readImage(folder / "x.png"));
    EXPECT_NE(imageHelperId(), first);
}

// A helper that is not there, ends at once, or talks nonsense: words, and no harm to what follows.
TEST(ImageFile, UselessHelpersAreToldAndReplaced)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "x.png", noiseImage(8, 8, 1, PixelType::U8)));
    const char* set = std::getenv("RELIEVO_IMAGEIO");
    const std::string before = set ? set : RELIEVO_BIN "/relievo-imageio";
    for (const char* useless : {"/nowhere/relievo-imageio", "/bin/true", "/bin/cat"}) {
        ::setenv("RELIEVO_IMAGEIO", useless, 1);
        if (const int id = imageHelperId())
            ::kill(id, SIGKILL);
        const auto read = readImage(folder / "x.png");
        ASSERT_FALSE(read) << useless;
        EXPECT_FALSE(read.error().hint.empty());
        EXPECT_FALSE(writeImage(folder / "y.png", noiseImage(8, 8, 1, PixelType::U8)));
        EXPECT_FALSE(fs::exists(folder / "y.png"));
    }
    ::setenv("RELIEVO_IMAGEIO", before.c_str(), 1);
    EXPECT_TRUE(readImage(folder / "x.png"));
}

TEST(ImageFile, CancelStopsReading)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "x.png", noiseImage(64, 64, 1, PixelType::U8)));
    std::stop_source source;
    source.request_stop();
    const auto read = readImage(folder / "x.png", Progress{{}, source.get_token()});
    ASSERT_FALSE(read);
    EXPECT_TRUE(isCancelled(read.error()));
    EXPECT_TRUE(readImage(folder / "x.png"));
}

// Every file of the broken collection is a picture or a sentence, and the helper works on.
TEST(ImageFile, BrokenFilesAreRefusedOrTold)
{
    const fs::path broken = dataFolder() / "broken";
    if (!fs::exists(broken))
        GTEST_SKIP() << "no test data beside the checkout";
    int files = 0;
    for (const char* folder : {"png", "exr", "dds_tga_hdr", "tiff"})
        for (const auto& entry : fs::directory_iterator(broken / folder)) {
            ++files;
            const auto read = readImage(entry.path());
            if (read) {
                EXPECT_FALSE(read->warnings.empty()) << entry.path() << " opened without a word";
                continue;
            }
            EXPECT_EQ(read.error().where, entry.path().string());
            EXPECT_FALSE(read.error().what.empty());
            EXPECT_EQ(read.error().what.find_first_of("\n\r"), std::string::npos);
        }
    EXPECT_GT(files, 50);
}

TEST(ImageFile, UnusualButValidFilesOpen)
{
    const fs::path broken = dataFolder() / "broken";
    if (!fs::exists(broken))
        GTEST_SKIP() << "no test data beside the checkout";
    for (const char* folder : {"exr_valid_but_nasty", "tiff_valid_unusual_depths"})
        for (const auto& entry : fs::directory_iterator(broken / folder)) {
            const auto read = readImage(entry.path());
            EXPECT_TRUE(read) << message(read.error());
        }
    EXPECT_TRUE(tells(readImage(broken / "exr_valid_but_nasty/t05.exr")->warnings, "data-window"));
    EXPECT_TRUE(tells(readImage(broken / "exr_valid_but_nasty/t09.exr")->warnings, "data-window"));
}

// The same flower at every depth (the 24-bit file repeats the 8-bit one's bytes): all agree within a step of the coarser.
TEST(ImageFile, UnusualDepthsKeepTheirValues)
{
    const fs::path folder = dataFolder() / "broken/tiff_valid_unusual_depths";
    if (!fs::exists(folder))
        GTEST_SKIP() << "no test data beside the checkout";
    const auto reference = readImage(folder / "flower-minisblack-32.tif");
    ASSERT_TRUE(reference);
    for (const int bits : {8, 10, 12, 16, 24}) {
        const auto read = readImage(folder / ("flower-minisblack-" + std::string(bits < 10 ? "0" : "") + std::to_string(bits) + ".tif"));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->image.storedBits, bits);
        EXPECT_FALSE(read->image.storedFloat);
        for (int y = 0; y < read->image.height; ++y)
            for (int x = 0; x < read->image.width; ++x)
                ASSERT_NEAR(read->image.value(x, y, 0), reference->image.value(x, y, 0),
                    1.01 / double((1 << (bits == 24 ? 8 : bits)) - 1) + 2.0 / 65535)
                    << bits;
    }
}

TEST(ImageFile, TwoFreshTimeOutsBlameTheHelper)
{
    HangGuard guard;
    const auto now = HangGuard::Clock::now();
    guard.note(HelperTrouble::TimedOut, false, now); // an old helper: perhaps hurt by an earlier file
    guard.note(HelperTrouble::TimedOut, true, now);
    EXPECT_FALSE(guard.refuses(now));
    guard.note(HelperTrouble::None, true, now);
    guard.note(HelperTrouble::TimedOut, true, now);
    EXPECT_FALSE(guard.refuses(now));
    guard.note(HelperTrouble::TimedOut, true, now);
    EXPECT_TRUE(guard.refuses(now));
    EXPECT_FALSE(guard.refuses(now + std::chrono::minutes(2)));
}

TEST(ImageFile, AnOrientationTagIsTold)
{
    const TemporaryFolder folder;
    // Big-endian Exif of one entry: orientation 6.
    const std::string exif("Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0", 32);
    ASSERT_TRUE(writeImage(folder / "a.jpg", noiseImage(16, 16, 3, PixelType::U8)));
    const std::string plain = readAll(folder / "a.jpg");
    writeAll(folder / "b.jpg", plain.substr(0, 2) + std::string("\xff\xe1\0\x22", 4) + exif + plain.substr(2));
    EXPECT_FALSE(tells(readImage(folder / "a.jpg")->warnings, "orientation"));
    const auto turned = readImage(folder / "b.jpg");
    ASSERT_TRUE(turned) << message(turned.error());
    EXPECT_TRUE(tells(turned->warnings, "orientation"));
}

} // namespace
