// Mutated files of the map cache whose checksum fits: of the right shape or not taken, and searched without harm.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/acceleration_map.h"
#include "core/maps/map_cache.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/fuzz/mutations.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/maps/maps_support.h"
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <xxhash.h>

using namespace relievo;
using namespace relievo::test;

namespace {
struct Seed {
    const TechniqueRow* technique;
    const BakedMapRow* row;
    std::string packed;
};

std::vector<Seed> seedsOf(const HeightField& field)
{
    std::vector<Seed> seeds;
    for (const TechniqueRow& technique : kTechniques) {
        const BakedMapRow* row = technique.accelerationMap.empty() ? nullptr : findBakedMap(technique.accelerationMap);
        if (!row)
            continue;
        const auto packed = packedMap("key", storedMap(*row, *bakeMap(*row, field, Parameters()), row->bits));
        seeds.push_back({&technique, row, {reinterpret_cast<const char*>(packed.data()), packed.size()}});
    }
    return seeds;
}

// Few bytes are changed, most of them in the heads; then the checksum is made to fit.
std::vector<std::byte> mutatedCache(const std::string& packed, std::mt19937& random)
{
    std::string body = packed.substr(0, packed.size() - sizeof(std::uint64_t));
    if (below(random, 4) == 0)
        body = mutated(body, packed, random);
    for (std::size_t edits = 1 + below(random, 4); edits > 0 && body.size() > 4; --edits) {
        const std::size_t at = below(random, below(random, 2) ? std::min<std::size_t>(body.size(), 96) : body.size());
        const std::uint32_t odd[] = {0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fc00000, 0x7f800000, 0x00000001, std::uint32_t(random())};
        const std::uint32_t word = odd[below(random, std::size(odd))];
        std::memcpy(body.data() + std::min(at, body.size() - 4), &word, below(random, 2) ? 4 : 1);
    }
    const std::uint64_t checksum = XXH3_64bits(body.data(), body.size());
    body.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    const auto bytes = std::as_bytes(std::span(body));
    return {bytes.begin(), bytes.end()};
}
} // namespace

TEST(CacheFuzz, MutatedFilesAreOfTheirShapeAndDoNoHarm)
{
    const HeightField field = fieldOf(13, 9, [](int x, int y) { return float((x * 7 + y * 5) % 11) / 10.f; });
    const std::vector<Seed> seeds = seedsOf(field);
    const std::vector<SearchRay> rays{{{0.1, 0.2}, {0.7, -0.4}, 0.3}, {{0.9, 0.5}, {0., 3.}, 0.1}, {{0.5, 0.5}, {0., 0.}, 1.}};
    int taken = 0;
    for (FuzzLoop loop(20000); loop.next();) {
        const Seed& seed = seeds[below(loop.random, seeds.size())];
        const MapShape shape = shapeOf(*seed.row, field);
        auto map = unpackedMap("key", shape, mutatedCache(seed.packed, loop.random));
        if (!map)
            continue;
        ASSERT_EQ(shapeOf(*map), shape) << seed.row->key << " round " << loop.round;
        for (const Image& level : map->levels)
            ASSERT_EQ(level.data.size(), level.texelCount() * std::size_t(level.channels) * bytesOf(level.type));
        if (!hasSoundValues(*seed.row, field, *map))
            continue;
        ++taken;
        SearchMaps maps{field, accelerationMapOf(*seed.row, {std::make_shared<const BakedMap>(std::move(*map))}, field)};
        const auto hits = traceRays(seed.technique->key, Parameters(), maps, rays);
        ASSERT_TRUE(hits);
        for (const SearchHit& hit : *hits)
            ASSERT_TRUE(hit.t >= 0. && hit.t <= 1.) << seed.technique->key << " round " << loop.round << " t " << hit.t;
    }
    EXPECT_GT(taken, 0);
}
