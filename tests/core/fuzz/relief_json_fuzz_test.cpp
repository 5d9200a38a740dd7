// Mutated relief.json: values within their ranges, or none.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/scene/relief_numbers.h"
#include "core/scene/source.h"
#include "tests/core/fuzz/mutations.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

TEST(ReliefJsonFuzz, MutatedFilesGiveValuesInRangeOrNone)
{
    const TemporaryFolder folder;
    State state = openSource("sample:hammered@16", State())->state;
    state.mesh = "box";
    const auto resources = loadResources(state, {}, {});
    ASSERT_TRUE(resources);
    ASSERT_TRUE(exportTextures({state, *resources, folder.path(), 0, {}}));
    const std::string good = readAll(folder / "relief.json");
    State named; // whose maps the file may turn
    named.slots = openSource(folder.path().string(), State())->state.slots;
    int taken = 0;
    for (FuzzLoop loop(1000); loop.next();) {
        const std::string bytes = mutated(good, good, loop.random);
        writeAll(folder / "relief.json", bytes);
        State read = named;
        Warnings warnings;
        taken += takeReliefJson(folder.path(), read, warnings);
        (void)unfinishedExport(folder.path());
        for (const ParameterRow& row : kParameters)
            EXPECT_TRUE(inRange(row, get(read.parameters, row))) << row.key;
        ASSERT_FALSE(HasFailure()) << "round " << loop.round << ": " << bytes;
    }
    EXPECT_GT(taken, 0);
}
