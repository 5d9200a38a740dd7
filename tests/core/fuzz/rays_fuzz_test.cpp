// Mutated CSV files of rays: rays that every search answers, or an error that names file and line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rays_csv.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/fuzz/mutations.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/image/image_support.h"
#include "tests/core/maps/maps_support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

using namespace relievo;
using namespace relievo::test;

TEST(RaysFuzz, MutatedFilesAreAnsweredOrRefused)
{
    const TemporaryFolder folder;
    const auto file = folder / "rays.csv";
    const std::string seeds[] = {"u,v,du,dv\n0.5,0.5,0.1,0\n0.25,0.75,-0.3,0.2\n", "u,v,du,dv,cosView\n0.5,0.5,0.1,0,0.5\n0,0,5,-3,1e-3\n",
        "\xEF\xBB\xBFu,v,du,dv\r\n1e-38,-1e38,3e38,1e-45\r\n\r\n-0,+1,1e5,0\r\n"};
    std::map<std::string_view, SearchMaps> maps;
    const HeightField fields[] = {fieldOf(13, 8, [](int x, int y) { return float((x * 7 + y * 5) % 11) / 10.f; }),
        fieldOf(
            1, 5, [](int, int y) { return float(y) / 4.f; }, Wrap::Clamp)};
    for (FuzzLoop loop(600); loop.next();) {
        const std::string bytes
            = mutated(seeds[below(loop.random, std::size(seeds))], seeds[below(loop.random, std::size(seeds))], loop.random);
        writeAll(file, bytes);
        const auto read = cli::readRays(file, 0.1);
        if (!read) {
            EXPECT_TRUE(read.error().where.starts_with(file.string())) << read.error().where;
            continue;
        }
        std::vector<SearchRay> rays = read->rays;
        rays.resize(std::min<std::size_t>(rays.size(), 4));
        const TechniqueRow& row = kTechniques[below(loop.random, kTechniques.size())];
        const HeightField& field = fields[below(loop.random, std::size(fields))];
        Parameters parameters;
        parameters.wrap = field.wrap();
        const auto hits = traceRays(row.key, parameters, &field, rays);
        ASSERT_TRUE(hits);
        for (const SearchHit& hit : *hits) {
            EXPECT_TRUE(hit.t >= 0. && hit.t <= 1. && hit.fetches >= 0) << row.key;
            EXPECT_FALSE(hit.found && hit.isUnfinished) << row.key;
        }
        for (const SearchRay& ray : read->rays)
            EXPECT_TRUE((ray.cosView > 0. && ray.cosView <= 1.) || !isFinite(ray)) << ray.cosView;
        EXPECT_EQ(std::ranges::count(cli::hitsText(*hits), '\n'), std::ptrdiff_t(hits->size()) + 1);
        ASSERT_FALSE(HasFailure()) << "round " << loop.round << ": " << bytes;
    }
}
