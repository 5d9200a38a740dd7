// Quarters of cells in the order of the ray, and in each the roots of two quadratics.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/axis_walk.h"
#include <cmath>
#include <limits>

namespace relievo {

namespace {
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1e-12; // share of a quarter's length by which a root may miss it, so that none falls between two
constexpr double kRounding = 1e-13; // share of t by which the same wall of two axes may lie in two places
constexpr double kTouches = 1e-9; // depths as near as this are the same: a surface there, no wall

// c + b s + a s^2
struct Quadratic {
    double a = 0., b = 0., c = 0.;
    double at(double s) const { return c + s * (b + s * a); }
    double slopeAt(double s) const { return b + 2. * s * a; }
};

struct Roots {
    std::array<double, 2> at{};
    int count = 0;
};

// Those in [0, length].
Roots rootsOf(const Quadratic& f, double length)
{
    Roots roots;
    const double discriminant = f.b * f.b - 4. * f.a * f.c, slack = kSlack * length;
    const auto add = [&](double root) {
        if (root >= -slack && root <= length + slack)
            roots.at[std::size_t(roots.count++)] = std::clamp(root, 0., length);
    };
    if (discriminant < 0.)
        return roots;
    const double q = -0.5 * (f.b + std::copysign(std::sqrt(discriminant), f.b)); // no cancellation
    if (q != 0.)
        add(f.c / q);
    if (f.a != 0.)
        add(q / f.a);
    return roots;
}

// How a depth differs from the ray's on the way through a quarter: ray less surface, s from where it enters.
struct Way {
    double x = 0., y = 0., depth = 0.; // where it enters; x, y from the cell's first corner, texels
    double slopeX = 0., slopeY = 0., sink = 0.;
    Quadratic above(const Bilinear& k) const
    {
        return {-k.xy * slopeX * slopeY, sink - k.x * slopeX - k.y * slopeY - k.xy * (x * slopeY + y * slopeX), depth - k.at(x, y)};
    }
    glm::dvec3 gradient(const Bilinear& k, double s) const // of the surface less the depth
    {
        return {k.x + k.xy * (y + s * slopeY), k.y + k.xy * (x + s * slopeX), -1.};
    }
};
} // namespace

double AxisWalk::Side::exit() const
{
    if (slope == 0. || (slope < 0. ? index == 0 : index == last))
        return kNever;
    return (double(slope < 0. ? index : index + 1) - start) / slope;
}

AxisWalk::Side AxisWalk::sideOf(double origin, double direction, int size, double from)
{
    Side side{double(size) * (1. + origin), double(size) * direction, 0, 2 * size - 1};
    const double at = side.start + from * side.slope, first = std::floor(at);
    const bool isLower = side.slope < 0. && at == first; // begins on the wall and leaves downwards
    side.index = int(std::clamp(isLower ? first - 1. : first, 0., double(side.last)));
    return side;
}

AxisWalk::AxisWalk(const AxisMap& map, const AxisFrame& frame, const BoxRay& ray)
    : m_map(map)
    , m_u(sideOf(glm::dot(ray.origin, frame.u), glm::dot(ray.direction, frame.u), map.width, ray.from))
    , m_v(sideOf(glm::dot(ray.origin, frame.v), glm::dot(ray.direction, frame.v), map.height, ray.from))
    , m_depth(0.5 + 0.5 * glm::dot(ray.origin, frame.depth))
    , m_sink(0.5 * glm::dot(ray.direction, frame.depth))
    , m_enter(ray.from)
    , m_end(ray.to)
{
    findSpans();
}

const Span* AxisWalk::from(double t)
{
    for (;;) {
        for (; m_next < m_spans.size(); ++m_next)
            if (const Span& span = m_spans[m_next]; span.to > t + kRounding * m_end || (span.from == span.to && span.to == t))
                return &m_spans[m_next];
        if (!step())
            return nullptr;
    }
}

bool AxisWalk::step()
{
    if (m_leave >= m_end)
        return false;
    const double exitU = m_u.exit(), exitV = m_v.exit();
    if (exitU <= m_leave) {
        m_u.index += m_u.slope < 0. ? -1 : 1;
        m_wall = {m_u.slope < 0. ? 1. : -1., 0., 0.};
    }
    if (exitV <= m_leave) {
        m_v.index += m_v.slope < 0. ? -1 : 1;
        m_wall = {0., m_v.slope < 0. ? 1. : -1., 0.};
    }
    m_enter = m_leave;
    findSpans();
    return true;
}

void AxisWalk::findSpans()
{
    m_spans.clear();
    m_next = 0;
    m_leave = std::max(m_enter, std::min({m_u.exit(), m_v.exit(), m_end}));
    for (int k = 0; k < m_map.layers; ++k)
        if (const auto layer = layerOn(m_map, {m_u.index, m_v.index}, k))
            addSpans(*layer, k);
    std::ranges::sort(m_spans, {}, &Span::from);
}

// Between two neighbouring roots the ray is either in the interval or outside.
void AxisWalk::addSpans(const Layer& layer, int number)
{
    const Quarter quarter{m_u.index, m_v.index};
    const Way way{0.5 * (m_u.start + m_enter * m_u.slope) - 0.5 - quarter.cellX(),
        0.5 * (m_v.start + m_enter * m_v.slope) - 0.5 - quarter.cellY(), m_depth + m_enter * m_sink, 0.5 * m_u.slope, 0.5 * m_v.slope,
        m_sink};
    const double length = m_leave - m_enter;
    const Quadratic front = way.above(layer.front), back = way.above(layer.back);
    const Roots frontRoots = rootsOf(front, length), backRoots = rootsOf(back, length);
    const auto add = [&](double from, double to) {
        Span span{m_enter + from, to >= length ? m_leave : m_enter + to, number, HitOn::Front, {}};
        const double past = std::abs(front.at(from)), left = std::abs(back.at(from));
        span.on = past > kTouches && left > kTouches ? HitOn::Wall : past <= left ? HitOn::Front : HitOn::Back;
        span.gradient = span.on == HitOn::Wall ? m_wall
            : span.on == HitOn::Front          ? way.gradient(layer.front, from)
                                               : -way.gradient(layer.back, from);
        if (layer.isThin && front.slopeAt(from) < 0.) { // met from behind
            span.on = HitOn::Back;
            span.gradient = -way.gradient(layer.back, from);
        }
        m_spans.push_back(span);
    };
    if (layer.isThin) {
        for (int i = 0; i < frontRoots.count; ++i)
            add(frontRoots.at[std::size_t(i)], frontRoots.at[std::size_t(i)]);
        return;
    }
    std::array<double, 6> ends; // what no root takes repeats the end
    ends.fill(length);
    ends[0] = 0.;
    std::size_t count = 1;
    for (const Roots& roots : {frontRoots, backRoots})
        for (int i = 0; i < roots.count; ++i)
            ends[count++] = roots.at[std::size_t(i)];
    std::ranges::sort(ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        const bool counts = ends[i + 1] > ends[i] || (length == 0. && i == 0);
        if (counts && front.at(middle) >= 0. && back.at(middle) <= 0.)
            add(ends[i], ends[i + 1]);
    }
}

} // namespace relievo
