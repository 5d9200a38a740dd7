// Stretches of all texels as intervals of 16 bits.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/bake_object.h"
#include "core/object/bake/align_layers.h"
#include "core/object/bake/columns.h"
#include <atomic>
#include <cmath>
#include <cstdio>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {

namespace {
constexpr double kThinnest = 1e-3; // of the largest size

// The narrowest gaps are closed until no more stretches are left than there are layers; whether any was.
bool fit(Stretches& stretches, std::size_t layers)
{
    if (stretches.size() <= layers)
        return false;
    while (stretches.size() > layers) {
        std::size_t narrowest = 1;
        const auto gap = [&](std::size_t i) { return stretches[i].first - stretches[i - 1].second; };
        for (std::size_t i = 2; i < stretches.size(); ++i)
            if (gap(i) < gap(narrowest))
                narrowest = i;
        stretches[narrowest - 1].second = stretches[narrowest].second;
        stretches.erase(stretches.begin() + std::ptrdiff_t(narrowest));
    }
    return true;
}

Interval intervalOf(const Stretch& stretch, bool reachesBack)
{
    const auto code = [](double depth) { return std::uint16_t(std::lround(depth * Interval::kDeepest)); };
    if (reachesBack) // a front at the very back would be read as nothing (core/object/object_sides.h)
        return {std::min(code(stretch.first), std::uint16_t(Interval::kDeepest - 1)), Interval::kDeepest};
    return {code(stretch.first), code(stretch.second)};
}

struct AxisBake {
    AxisMap map;
    std::size_t merged = 0, filled = 0; // texels
};

AxisBake bakeAxis(const AxisView& view, const ObjectOptions& options, const Progress& progress)
{
    const bool reachesBack = options.sides == ObjectSides::One;
    const auto size = std::size_t(options.size), layers = std::size_t(options.layers);
    AxisBake bake{{options.size, options.size, options.layers, std::vector<Interval>(size * size * layers)}, 0, 0};
    const auto& lidsOf = view.shells->lids;
    const Bands bands(
        view.shells->kinds.size(), [&](std::size_t t) { return view.corners(std::uint32_t(t)); }, options.size);
    const Bands lids(
        lidsOf.size(), [&](std::size_t t) { return view.onAxis(lidsOf[t]); }, options.size);
    std::atomic<std::size_t> merged = 0, filled = 0;
    std::atomic<int> done = 0;
    oneapi::tbb::parallel_for(0, bands.count(), [&](int band) {
        if (progress.cancelled())
            return;
        std::vector<Stretches> texels = bandStretches(view, {bands.of(band), lids.of(band), band, options.size}, options.supersample);
        std::size_t at = std::size_t(band) * kBandRows * size, some = 0, many = 0;
        for (Stretches& stretches : texels) {
            some += !stretches.empty();
            if (reachesBack && !stretches.empty())
                stretches = {{stretches.front().first, 1.}};
            many += fit(stretches, layers);
            for (std::size_t k = 0; k < stretches.size(); ++k)
                bake.map.intervals[at * layers + k] = intervalOf(stretches[k], reachesBack);
            ++at;
        }
        merged += many;
        filled += some;
        progress.at(float(++done) / float(bands.count()));
    });
    if (!progress.cancelled())
        alignLayers(bake.map);
    bake.merged = merged;
    bake.filled = filled;
    return bake;
}

Expected<void> check(const ObjectOptions& options)
{
    const auto isWithin = [](int value, int most) { return value >= 1 && value <= most; };
    if (!isWithin(options.size, kLargestObjectMap) || !isWithin(options.layers, kMostLayers) || !isWithin(options.supersample, kMostRays))
        return failure("impostor", "size, layers or rays are out of range");
    return {};
}

void tellOfMesh(const MeshShells& shells, const ObjectBox& box, Warnings& warnings)
{
    if (shells.openTriangles > 0)
        warnings.push_back({"open-mesh",
            "The mesh is not closed: " + std::to_string(shells.openTriangles)
                + " triangles belong to parts with holes. Inside is where they wind around a point more than half; the rest are sheets."});
    if (shells.facesInwards)
        warnings.push_back({"facing-inwards", "The triangles face inwards: they were taken as if they faced outwards."});
    const double largest = std::max({box.half.x, box.half.y, box.half.z});
    if (std::min({box.half.x, box.half.y, box.half.z}) <= kThinnest * largest * 1.0001)
        warnings.push_back({"flat-mesh", "The mesh is flat: its box was given a thousandth of its largest size as thickness."});
}
} // namespace

Expected<ObjectBox> boxOf(const Mesh& mesh)
{
    if (mesh.indices.empty())
        return failure(mesh.name, "the mesh has no triangles");
    glm::dvec3 low = mesh.vertices[mesh.indices.front()].position, high = low;
    for (const std::uint32_t index : mesh.indices) {
        low = glm::min(low, glm::dvec3(mesh.vertices[index].position));
        high = glm::max(high, glm::dvec3(mesh.vertices[index].position));
    }
    const double largest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (!(largest > 0.))
        return failure(mesh.name, "the mesh has no extent: all of it lies in one point");
    return ObjectBox{0.5 * (low + high), 0.5 * glm::max(high - low, glm::dvec3(kThinnest * largest))};
}

std::array<bool, 3> axesOf(ObjectSides sides)
{
    const bool all = sides == ObjectSides::Six;
    return {all, all, true};
}

Expected<BakedDepths> bakeDepths(const MeshSurface& surface, const ObjectOptions& options, const Progress& progress)
{
    if (const auto fits = check(options); !fits)
        return tl::unexpected(fits.error());
    const Mesh& mesh = surface.mesh();
    const auto box = boxOf(mesh);
    if (!box)
        return tl::unexpected(box.error());
    std::vector<char> isCut(mesh.indices.size() / 3);
    for (std::size_t t = 0; t < isCut.size(); ++t)
        isCut[t] = surface.isCut(t);
    const MeshShells shells = shellsOf(mesh, isCut);
    progress.at(0.2f);
    BakedDepths baked;
    baked.box = *box;
    tellOfMesh(shells, *box, baked.warnings);
    ReliefObject& object = baked.object;
    object.center = box->center;
    object.half = {glm::dvec3(box->half.x, 0., 0.), glm::dvec3(0., box->half.y, 0.), glm::dvec3(0., 0., box->half.z)};
    const auto axes = axesOf(options.sides);
    std::size_t merged = 0, filled = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!axes[axis])
            continue;
        const AxisView view{&surface, &shells, *box, axis, options.sides == ObjectSides::Six};
        const float from = axes[0] ? 0.2f + 0.8f * float(axis) / 3.f : 0.2f, to = axes[0] ? from + 0.8f / 3.f : 1.f;
        AxisBake bake = bakeAxis(view, options, progress.part(from, to));
        if (progress.cancelled())
            return cancelled(mesh.name);
        object.axes[axis] = std::move(bake.map);
        merged += bake.merged;
        filled += bake.filled;
    }
    if (merged > 0) {
        char share[32];
        std::snprintf(share, sizeof share, "%.2g", 100. * double(merged) / double(filled));
        baked.warnings.push_back({"layers-merged",
            std::string(share) + " % of the texels hold more than " + std::to_string(options.layers)
                + " intervals: their narrowest gaps were closed." + (options.layers < kMostLayers ? " More layers keep them open." : "")});
    }
    return baked;
}

} // namespace relievo
