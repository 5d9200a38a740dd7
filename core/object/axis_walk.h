// Where a ray is within the solid of one axis: stretch after stretch along the ray.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/object_cells.h"
#include "core/object/object_search.h"

namespace relievo {

// A ray by the measure of the box, from -1 to 1; it is in the box from t = from to t = to.
struct BoxRay {
    glm::dvec3 origin{0.}, direction{0.};
    double from = 0., to = 0.;
};

// From `from` on until before `to`: what only touches at a wall does not hang together. A solid without thickness: from == to.
// Neighbours in the same solid may follow one another.
struct Span {
    double from = 0., to = 0.;
    int layer = 0;
    HitOn on = HitOn::Front; // what lies at `from`
    glm::dvec3 gradient{0.}; // of what lies there, outwards, by u, v (texels) and depth (0..1)
};

class AxisWalk {
public:
    // map and ray must outlive it; the map is given, and sound (checkObject).
    AxisWalk(const AxisMap& map, const AxisFrame& frame, const BoxRay& ray);

    // The first stretch that reaches t, or begins after it; t never less than the last time. Null when there is none.
    const Span* from(double t);

private:
    // One side of the quarters' walk, in halves of texels.
    struct Side {
        double start = 0., slope = 0.; // at t = 0, for each unit of t
        int index = 0, last = 0;
        double exit() const;
    };
    static Side sideOf(double origin, double direction, int size, double from);
    bool step(); // to the next quarter; false beyond the last
    void findSpans();
    void addSpans(const Layer& layer, int number);

    const AxisMap& m_map;
    Side m_u, m_v;
    double m_depth = 0., m_sink = 0.; // at t = 0, for each unit of t
    double m_enter = 0., m_leave = 0., m_end = 0.;
    glm::dvec3 m_wall{0.}; // what was passed last, outwards
    std::vector<Span> m_spans; // of the quarter
    std::size_t m_next = 0;
};

} // namespace relievo
