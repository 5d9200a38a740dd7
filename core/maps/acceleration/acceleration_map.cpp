// Acceleration maps for every mip level, put together for the search.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/acceleration_map.h"
#include "core/maps/maps.h"
#include "core/maps/memory_guard.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// Share of source texel i (of `from`) in texel k of `to` along one axis: areas of a halving that rounds down overlap unevenly.
struct Span {
    int first, last;
    float firstShare, lastShare; // of the outer texels
    float share(int i) const { return i == first ? firstShare : i == last ? lastShare : 1.f; }
};
Span spanOf(int k, int to, int from)
{
    const double begin = double(k) * from / to, end = double(k + 1) * from / to;
    const int first = int(begin), last = std::min(int(std::ceil(end)) - 1, from - 1);
    return {first, last, float(std::min(end, first + 1.) - begin), last > first ? float(end - last) : 0.f};
}

HeightField halved(const HeightField& field)
{
    const int width = std::max(1, field.width() / 2), height = std::max(1, field.height() / 2);
    std::vector<float> heights(std::size_t(width) * std::size_t(height));
    tbb::parallel_for(0, height, [&](int y) {
        const Span rows = spanOf(y, height, field.height());
        for (int x = 0; x < width; ++x) {
            const Span columns = spanOf(x, width, field.width());
            float sum = 0.f, total = 0.f;
            for (int j = rows.first; j <= rows.last; ++j)
                for (int i = columns.first; i <= columns.last; ++i) {
                    const float share = rows.share(j) * columns.share(i);
                    sum += share * field.texel(i, j);
                    total += share;
                }
            heights[std::size_t(y) * std::size_t(width) + std::size_t(x)] = std::clamp(asStored(sum / total, field.storedBits()), 0.f, 1.f);
        }
    });
    return {width, height, std::move(heights), field.wrap(), field.storedBits()};
}

int shelfSize(int size, int shelf)
{
    return ((size - 1) >> shelf) + 1;
}

// One image with the levels from 1 on of the pyramids of all height levels.
Image shelves(const std::vector<std::shared_ptr<const BakedMap>>& pyramids, int width, int height)
{
    int last = 0, longest = 1, total = 0;
    for (std::size_t i = 0; i < pyramids.size(); ++i)
        last = std::max(last, int(i + pyramids[i]->levels.size()) - 1);
    std::vector<int> begin(std::size_t(last) + 2, 0);
    for (int s = 1; s <= last; ++s) {
        longest = std::max(longest, s * shelfSize(width, s));
        begin[std::size_t(s)] = total;
        total += shelfSize(height, s);
    }
    const Image& model = pyramids.front()->levels.front();
    const std::size_t texel = bytesOf(model.type);
    Image out{longest, std::max(total, 1), 1, model.type, model.storedBits, model.storedFloat, {}};
    out.data.resize(out.texelCount() * texel);
    for (std::size_t i = 0; i < pyramids.size(); ++i)
        for (std::size_t l = 1; l < pyramids[i]->levels.size(); ++l) {
            const Image& level = pyramids[i]->levels[l];
            const int x = int(l - 1) * shelfSize(width, int(i + l));
            for (int y = 0; y < level.height; ++y)
                std::memcpy(out.data.data() + (std::size_t(begin[i + l] + y) * std::size_t(longest) + std::size_t(x)) * texel,
                    level.data.data() + std::size_t(y) * std::size_t(level.width) * texel, std::size_t(level.width) * texel);
        }
    return out;
}

// Levels as one texture holds them: each of half the size of the one before, rounded down, and at least 1. Texels that are added are never
// read.
void padToHalving(std::vector<Image>& levels)
{
    int width = 1, height = 1;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        width = std::max(width, levels[i].width > 1 ? levels[i].width << i : 1);
        height = std::max(height, levels[i].height > 1 ? levels[i].height << i : 1);
    }
    for (std::size_t i = 0; i < levels.size(); ++i) {
        Image& level = levels[i];
        const std::size_t texel = level.data.size() / level.texelCount(), row = std::size_t(level.width) * texel;
        Image padded{
            std::max(width >> i, 1), std::max(height >> i, 1), level.channels, level.type, level.storedBits, level.storedFloat, {}};
        padded.data.resize(padded.texelCount() * texel);
        for (int y = 0; y < level.height; ++y)
            std::memcpy(
                padded.data.data() + std::size_t(y) * std::size_t(padded.width) * texel, level.data.data() + std::size_t(y) * row, row);
        level = std::move(padded);
    }
}

} // namespace

std::vector<HeightField> heightLevels(const HeightField& field)
{
    std::vector<float> heights(field.texels().begin(), field.texels().end());
    bool same = true;
    for (float& h : heights) {
        const float stored = asStored(h, field.storedBits());
        same = same && stored == h;
        h = stored;
    }
    std::vector<HeightField> levels;
    levels.push_back(same ? field : HeightField(field.width(), field.height(), std::move(heights), field.wrap(), field.storedBits()));
    while (levels.back().width() > 2 || levels.back().height() > 2)
        levels.push_back(halved(levels.back()));
    return levels;
}

int levelCount(const HeightField& field)
{
    int count = 1;
    for (int longer = std::max(field.width(), field.height()); longer > 2; longer /= 2)
        ++count;
    return count;
}

std::size_t AccelerationMap::bytes() const
{
    std::size_t sum = 0;
    for (const Image& level : levels)
        sum += level.data.size();
    return sum;
}

std::shared_ptr<const AccelerationMap> accelerationMapOf(
    const BakedMapRow& row, const std::vector<std::shared_ptr<const BakedMap>>& maps, const HeightField& field)
{
    auto texture = std::make_shared<AccelerationMap>();
    texture->slices = maps.front()->slices;
    texture->form = row.form;
    if (row.form == MapForm::Pyramid)
        texture->levels.push_back(shelves(maps, field.width(), field.height()));
    for (const auto& map : maps) {
        texture->scales.push_back(map->scale);
        if (row.form != MapForm::Pyramid && (row.form != MapForm::Volume || texture->levels.empty()))
            texture->levels.push_back(map->levels.front());
    }
    if (row.form == MapForm::Codes && maps.size() > 1)
        padToHalving(texture->levels);
    return texture;
}

Expected<std::shared_ptr<const AccelerationMap>> makeAccelerationMap(
    std::string_view bound, const HeightField& field, const Parameters& parameters, bool allLevels, const Progress& progress)
{
    const BakedMapRow& row = *findBakedMap(bound);
    return withinMemory(bound, [&]() -> Expected<std::shared_ptr<const AccelerationMap>> {
        const std::vector<HeightField> heights = allLevels ? heightLevels(field) : std::vector<HeightField>{field};
        std::vector<std::shared_ptr<const BakedMap>> maps;
        for (std::size_t i = 0; i < heights.size() && int(i) < kMaxHeightLevels; ++i) {
            if (row.form == MapForm::Volume && i > 0) {
                maps.push_back(maps.front());
                continue;
            }
            auto map = cachedMap(row, heights[i], parameters, i == 0 ? progress : Progress{{}, progress.stop});
            if (!map)
                return tl::unexpected(map.error());
            maps.push_back(std::move(*map));
        }
        return accelerationMapOf(row, maps, field);
    });
}

} // namespace relievo
