// The definition of a relief object at a point, and its checks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/relief_object.h"
#include "core/object/object_cells.h"
#include <cmath>
#include <string>

namespace relievo {

namespace {
bool isInside(const AxisMap& map, const AxisFrame& frame, glm::dvec3 p)
{
    const auto share = [&](glm::dvec3 direction) { return 0.5 + 0.5 * glm::dot(p, direction); };
    const double u = share(frame.u) * map.width, v = share(frame.v) * map.height, depth = share(frame.depth);
    const Quarter quarter{std::clamp(int(2. * u), 0, 2 * map.width - 1), std::clamp(int(2. * v), 0, 2 * map.height - 1)};
    const double x = u - 0.5 - quarter.cellX(), y = v - 0.5 - quarter.cellY();
    for (int k = 0; k < map.layers; ++k)
        if (const auto layer = layerOn(map, quarter, k); layer && layer->front.at(x, y) <= depth && depth <= layer->back.at(x, y))
            return true;
    return false;
}

std::string nameOf(std::size_t axis)
{
    return std::string(1, char('x' + axis));
}

Expected<void> checkShape(const AxisMap& map, std::size_t axis)
{
    if (map.height < 1 || map.layers < 1 || map.layers > kMostLayers)
        return failure(nameOf(axis), "the map along this axis has no texels, or not 1 to " + std::to_string(kMostLayers) + " layers");
    if (map.intervals.size() != std::size_t(map.width) * std::size_t(map.height) * std::size_t(map.layers))
        return failure(nameOf(axis), "the map along this axis does not hold as many intervals as its size says");
    return {};
}

struct Faults {
    std::size_t backwards = 0, crossing = 0;
};
Faults faultsOf(const AxisMap& map)
{
    Faults faults;
    int end = 0; // of the layers of this texel so far
    for (std::size_t i = 0; i < map.intervals.size(); ++i) {
        const Interval& here = map.intervals[i];
        faults.backwards += !here.isSolid() && here != Interval();
        if (i % std::size_t(map.layers) == 0)
            end = 0;
        if (!here.isSolid())
            continue;
        faults.crossing += here.front < end;
        end = here.back;
    }
    return faults;
}
} // namespace

bool isInside(const ReliefObject& object, glm::dvec3 point)
{
    const glm::dvec3 p = object.inBox(point);
    if (!(std::abs(p.x) <= 1. && std::abs(p.y) <= 1. && std::abs(p.z) <= 1.))
        return false;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (object.axes[axis].isGiven() && !isInside(object.axes[axis], kAxisFrames[axis], p))
            return false;
    return true;
}

Expected<Warnings> checkObject(const ReliefObject& object)
{
    Warnings warnings;
    bool anyGiven = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double length = glm::length(object.half[axis]);
        if (!(length > 0.) || !std::isfinite(length))
            return failure(nameOf(axis), "the box has no extent along this axis", "Give it a length above 0");
        const AxisMap& map = object.axes[axis];
        if (!map.isGiven())
            continue;
        anyGiven = true;
        if (auto shape = checkShape(map, axis); !shape)
            return tl::unexpected(shape.error());
        const Faults faults = faultsOf(map);
        const auto tell = [&](const char* code, std::size_t count, const char* what) {
            if (count > 0)
                warnings.push_back({code, std::to_string(count) + " intervals along " + nameOf(axis) + ' ' + what});
        };
        tell("back-before-front", faults.backwards, "end before they begin: they are empty.");
        tell("layers-cross", faults.crossing, "begin before the layer above them ends.");
    }
    if (!anyGiven)
        return failure("x, y, z", "there is no map along any axis", "Give the maps of one axis at least");
    return warnings;
}

} // namespace relievo
