// What the ray inspector computes in the background: each pane's search along the ray behind one point of the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/ray_inspection.h"
#include "core/scene/resources.h"
#include <QString>
#include <optional>
#include <vector>

namespace relievo {

// A point of a pane's picture.
struct PickedPoint {
    std::size_t pane = 0;
    glm::vec2 at{0.5f}; // share of the picture, from its upper left corner
    float aspect = 1.f; // width / height of it
    bool operator==(const PickedPoint&) const = default;
};

struct PaneInspection {
    std::size_t pane = 0;
    QString name; // "A  Relief mapping"
    std::optional<RayInspection> view, light; // of the eye, and of the light to the point that was found
};
struct Inspected {
    std::vector<PaneInspection> panes; // empty where there is nothing to inspect
    std::optional<HeightField> field; // as the picked pane wraps it
    QString note; // what has to be known: nothing there, a ray that is straight here only ...
};

// All panes are looked at with the picked pane's camera, at full resolution. Acceleration maps come from the resources, or are made.
Inspected inspect(const State& state, const Resources& resources, const PickedPoint& point, const Progress& progress);

} // namespace relievo
