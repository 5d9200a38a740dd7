// Sizes of files, guessed before they are written, against those that are written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/file_sizes.h"
#include "core/scene/source.h"
#include "tests/core/image/image_support.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
// As a ratio above 1, whichever is larger; of all files of the target together.
double offBy(const std::string& source, const char* target, int size)
{
    const TemporaryFolder folder;
    const auto opened = openSource(source, State());
    EXPECT_TRUE(opened) << source;
    if (!opened)
        return 0.;
    const auto resources = loadResources(opened->state, opened->images, {});
    EXPECT_TRUE(resources);
    const ExportRow& row = *findExport(target);
    const ExportJob job{opened->state, *resources, folder / ("out" + std::string(row.suffix)), size, {}};
    double guessed = 0., written = 0.;
    for (const fs::path& file : row.writes(job))
        guessed += aboutBytes(row, job, file);
    const auto exported = row.run(job);
    EXPECT_TRUE(exported) << message(exported.error());
    for (const fs::path& file : exported->files)
        written += double(fs::file_size(file));
    return std::exp(std::abs(std::log(guessed / written)));
}
} // namespace

TEST(FileSizes, AreGuessedOfRealSets)
{
    const fs::path sets = fs::path(RELIEVO_TEST_DATA) / "materials";
    if (!fs::exists(sets))
        GTEST_SKIP() << "there are no real sets at " << sets;
    for (const char* set : {"ambientcg_ground037_packed", "3dtextures_rock_024_dx", "pk02_panels01a_dx"})
        for (const char* target : {"textures", "packed", "gltf"}) {
            const double off = offBy((sets / set).string(), target, 512);
            EXPECT_LT(off, 1.25) << set << " as " << target;
            RecordProperty(std::string(set) + ' ' + target, std::to_string(off));
        }
}

TEST(FileSizes, AreGuessedOfReducedPictures)
{
    EXPECT_LT(offBy("sample:bricks@512", "packed", 128), 1.25);
    EXPECT_LT(offBy("sample:cobblestones@64", "textures", 0), 1.25) << "all rows are tried where there are few";
}
