// Environments: sizes, energy and directions of the studio, and pictures brought to the same form.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment.h"
#include "core/image/files/image_file.h"
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace relievo;
namespace fs = std::filesystem;

static double meanOf(const std::vector<glm::vec3>& level, int width)
{
    double sum = 0, area = 0;
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const double w = std::sin(3.14159265 * (y + 0.5) / (width / 2));
            const glm::vec3 c = level[std::size_t(y * width + x)];
            sum += w * double(c.x + c.y + c.z) / 3.0;
            area += w;
        }
    return sum / area;
}

TEST(Environment, StudioHasAllLevelsAndKeepsItsEnergy)
{
    const Environment studio = studioEnvironment();
    ASSERT_EQ(studio.levels.size(), std::size_t(kEnvironmentLevels));
    for (int k = 0; k < kEnvironmentLevels; ++k) {
        const int width = kEnvironmentWidth >> k;
        ASSERT_EQ(studio.levels[std::size_t(k)].size(), std::size_t(width * width / 2));
        EXPECT_NEAR(meanOf(studio.levels[std::size_t(k)], width), 1.0, 0.12) << k;
        for (const glm::vec3& c : studio.levels[std::size_t(k)]) {
            ASSERT_TRUE(std::isfinite(c.x + c.y + c.z));
            ASSERT_GE(std::min({c.x, c.y, c.z}), 0.f);
        }
    }
    EXPECT_NEAR(meanOf(studio.levels[0], kEnvironmentWidth), 1.0, 1e-3);
}

TEST(Environment, KeyLightComesFromAboveLeft)
{
    const Environment studio = studioEnvironment();
    const auto& matt = studio.levels.back(); // 8 x 4; u grows from +z over -x to -z (u = 0.5), then +x
    EXPECT_GT(matt[1].x, matt[3 * 8 + 1].x); // up is brighter than down
    EXPECT_GT(matt[8 + 1].x, matt[8 + 5].x); // -x is brighter than +x
}

TEST(Environment, PicturesAreResampledAndConstantOnesStayConstant)
{
    std::string name = (fs::temp_directory_path() / "relievo-environment-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    Image image{37, 19, 3, PixelType::F32, 32, true, {}};
    const float value = 2.5f;
    for (std::size_t i = 0; i < 37 * 19 * 3; ++i) {
        const auto* raw = reinterpret_cast<const std::byte*>(&value);
        image.data.insert(image.data.end(), raw, raw + 4);
    }
    ASSERT_TRUE(writeImage(folder / "sky.hdr", image));
    const Expected<Environment> sky = openEnvironment((folder / "sky.hdr").string());
    fs::remove_all(folder);
    ASSERT_TRUE(sky) << message(sky.error());
    EXPECT_EQ(sky->name, "sky");
    for (const auto& level : sky->levels)
        for (const glm::vec3& c : level)
            ASSERT_NEAR(c.y, 2.5f, 0.02f);
    const Expected<Environment> missing = openEnvironment("/nowhere/sky.hdr");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().where, "/nowhere/sky.hdr");
}
