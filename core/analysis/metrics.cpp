// Counting wrong hits.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"
#include "core/trace/exact_search.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace relievo {

namespace {

bool valid(const SearchHit& hit)
{
    return hit.t >= 0. && hit.t <= 1. && std::isfinite(hit.uv.x) && std::isfinite(hit.uv.y);
}

double texelsOf(const HeightField& field, glm::dvec2 shift)
{
    return std::hypot(shift.x * field.width(), shift.y * field.height());
}

// Within what the exact answer would be on a surface a hair higher or lower.
bool tied(const ExactSearch& search, const SearchRay& ray, double t)
{
    return t >= search.hit(ray, kTieHeight).t && t <= search.hit(ray, -kTieHeight).t;
}

void countFetches(HitErrors& errors, std::vector<int>& fetches)
{
    if (fetches.empty())
        return;
    double sum = 0.;
    for (const int f : fetches)
        sum += f;
    errors.meanFetches = sum / double(fetches.size());
    const auto at = fetches.begin() + std::ptrdiff_t((fetches.size() - 1) * 99 / 100);
    std::nth_element(fetches.begin(), at, fetches.end());
    errors.p99Fetches = *at;
    errors.maxFetches = *std::max_element(at, fetches.end());
}

} // namespace

HitErrors compareHits(const HeightField& field, std::span<const SearchRay> rays, std::span<const SearchHit> hits,
    std::span<const SearchHit> exact, std::span<const double> pixels)
{
    assert(rays.size() == hits.size() && rays.size() == exact.size() && (pixels.empty() || pixels.size() == rays.size()));
    HitErrors errors;
    std::vector<int> fetches;
    std::optional<ExactSearch> search; // made for the first hit in doubt
    double squares = 0., squaresTexels = 0., squaresPixels = 0.;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!exact[i].found)
            continue;
        if (!valid(hits[i])) {
            ++errors.invalid;
            continue;
        }
        const double t = hits[i].found ? hits[i].t : 1., difference = t - exact[i].t, distance = std::abs(difference);
        const glm::dvec2 uv = hits[i].found ? hits[i].uv : rays[i].uv + rays[i].duv;
        const double texels = texelsOf(field, uv - exact[i].uv);
        fetches.push_back(hits[i].fetches);
        errors.meanBytes += hits[i].bytes;
        ++errors.rays;
        errors.notFound += !hits[i].found;
        if (distance > kWrongDepth && texels > kWrongTexels) {
            if (!search)
                search.emplace(field);
            if (tied(*search, rays[i], t)) {
                ++errors.ties;
                continue;
            }
            ++(difference > 0. ? errors.tooDeep : errors.tooShort);
        }
        squares += difference * difference;
        squaresTexels += texels * texels;
        if (!pixels.empty())
            squaresPixels += difference * difference * pixels[i] * pixels[i];
        errors.largest = std::max(errors.largest, distance);
        errors.largestTexels = std::max(errors.largestTexels, texels);
    }
    const double count = double(std::max<std::size_t>(errors.rays, 1));
    const double told = double(std::max<std::size_t>(errors.rays - errors.ties, 1));
    errors.rmse = std::sqrt(squares / told);
    errors.rmseTexels = std::sqrt(squaresTexels / told);
    errors.rmsePixels = std::sqrt(squaresPixels / told);
    errors.meanBytes /= count;
    countFetches(errors, fetches);
    return errors;
}

HitErrors together(std::span<const HitErrors> sets)
{
    HitErrors all;
    for (const HitErrors& set : sets) {
        const double weight = double(set.rays), told = double(set.rays - set.ties);
        all.rays += set.rays, all.invalid += set.invalid, all.ties += set.ties;
        all.tooDeep += set.tooDeep, all.tooShort += set.tooShort, all.notFound += set.notFound;
        all.rmse += told * set.rmse * set.rmse;
        all.rmseTexels += told * set.rmseTexels * set.rmseTexels;
        all.rmsePixels += told * set.rmsePixels * set.rmsePixels;
        all.meanFetches += weight * set.meanFetches;
        all.meanBytes += weight * set.meanBytes;
        all.p99Fetches += weight * set.p99Fetches;
        all.largest = std::max(all.largest, set.largest);
        all.largestTexels = std::max(all.largestTexels, set.largestTexels);
        all.maxFetches = std::max(all.maxFetches, set.maxFetches);
    }
    const double weight = double(std::max<std::size_t>(all.rays, 1)), told = double(std::max<std::size_t>(all.rays - all.ties, 1));
    all.rmse = std::sqrt(all.rmse / told), all.rmseTexels = std::sqrt(all.rmseTexels / told);
    all.rmsePixels = std::sqrt(all.rmsePixels / told);
    all.meanFetches /= weight, all.meanBytes /= weight, all.p99Fetches /= weight;
    return all;
}

} // namespace relievo
