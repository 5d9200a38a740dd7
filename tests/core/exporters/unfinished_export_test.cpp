// An export of textures that was ended in the middle is seen to be unfinished, whenever that was.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/scene/relief_numbers.h"
#include "core/scene/source.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
struct Job {
    test::TemporaryFolder folder;
    fs::path out = folder / "set";
    State state;
    Resources resources;
    Job()
    {
        state = openSource("sample:hammered@64", State())->state;
        state.mesh = "box";
        resources = *loadResources(state, {}, {});
    }
    Expected<Exported> run(const Progress& progress = {}) { return exportTextures({state, resources, out, 0, progress}); }
};

bool holdsMaps(const fs::path& folder)
{
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code))
        if (entry.path().extension() == ".png")
            return true;
    return false;
}
} // namespace

// What a kill leaves is what lies there at that moment.
TEST(UnfinishedExport, NoMapLiesThereWithoutTheMark)
{
    Job job;
    int looked = 0;
    Progress progress;
    progress.report = [&](float) {
        if (holdsMaps(job.out)) {
            ++looked;
            EXPECT_TRUE(unfinishedExport(job.out));
        }
    };
    ASSERT_TRUE(job.run(progress));
    EXPECT_GT(looked, 0);
    EXPECT_FALSE(unfinishedExport(job.out));
}

TEST(UnfinishedExport, IsToldAndGivesNoValues)
{
    Job job;
    job.state.parameters.depth = 0.031f;
    ASSERT_TRUE(job.run());
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    progress.report = [&](float share) {
        if (share > 0.f && share < 1.f)
            stop.request_stop();
    };
    const auto stopped = job.run(progress); // over the first one
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
    auto opened = openSource(job.out.string(), State());
    ASSERT_TRUE(opened);
    EXPECT_TRUE(test::tells(opened->warnings, "export-unfinished"));
    EXPECT_FALSE(test::tells(opened->warnings, "relief-json"));
    EXPECT_FALSE(opened->bringsValues);

    ASSERT_TRUE(job.run());
    opened = openSource(job.out.string(), State());
    ASSERT_TRUE(opened);
    EXPECT_FALSE(test::tells(opened->warnings, "export-unfinished"));
    EXPECT_FLOAT_EQ(opened->state.parameters.depth, 0.031f);
}

TEST(UnfinishedExport, ARefusedExportChangesNothing)
{
    Job job;
    ASSERT_TRUE(job.run());
    const std::string before = *readText(job.out / "relief.json");
    auto opened = openSource(job.out.string(), State());
    ASSERT_TRUE(opened);
    opened->state.name = job.state.name; // its maps would go where they were read
    const auto resources = loadResources(opened->state, opened->images, {});
    ASSERT_TRUE(resources);
    EXPECT_FALSE(exportTextures({opened->state, *resources, job.out, 0, {}}));
    EXPECT_EQ(*readText(job.out / "relief.json"), before);
}
