// Pieces of the teapot: rings swept along bent axes, all by uniform cubic B-splines.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/teapot.h"
#include "core/mesh/shapes/shape_grid.h"
#include <algorithm>
#include <span>

namespace relievo {

namespace {
struct Bent {
    glm::vec2 at, slope, bend; // value, first and second derivative
};

// The spline of the points at p in [0, points - 1]; before and after them stand `before` and `after`.
Bent spline(std::span<const glm::vec2> points, glm::vec2 before, glm::vec2 after, float p)
{
    const int last = int(points.size()) - 1, i = std::clamp(int(p), 0, last - 1);
    const auto point = [&](int k) { return k < 0 ? before : k > last ? after : points[std::size_t(k)]; };
    const glm::vec2 a = point(i - 1), b = point(i), c = point(i + 1), d = point(i + 2);
    const float t = p - float(i), r = 1.f - t;
    return {
        (a * (r * r * r) + b * (4.f - 6.f * t * t + 3.f * t * t * t) + c * (4.f - 6.f * r * r + 3.f * r * r * r) + d * (t * t * t)) / 6.f,
        0.5f * ((b - a) * (r * r) + (c - b) * (2.f * r * t) + (d - c) * (t * t)) + 0.5f * (c - b),
        (a - b * 2.f + c) * r + (b - c * 2.f + d) * t};
}

// The axis of a piece in the plane z = 0, straight on beyond its ends.
Bent axisAt(std::span<const glm::vec2> axis, float along)
{
    return spline(axis, axis[0] * 2.f - axis[1], axis.back() * 2.f - axis[axis.size() - 2], along);
}

// The outline of a piece: way along the axis and radius. An end with radius 0 closes it, round.
Bent profileAt(std::span<const glm::vec2> profile, float p)
{
    const auto mirrored = [](glm::vec2 q) { return glm::vec2(q.x, -q.y); };
    return spline(profile, mirrored(profile[1]), mirrored(profile[profile.size() - 2]), p);
}

struct Piece {
    std::span<const glm::vec2> axis, profile;
    float from, to; // in points of the profile
    float tiles; // around
    unsigned columns, rows;
};

struct Ring {
    glm::vec2 centre, along; // unit vector of the axis
    float radius, outwards, onwards; // the normal is `outwards` off the axis less `onwards` along it, where the axis is straight
    float bend; // radians a metre, to the left
    float pace; // metres of the outline per point of the profile
};

Ring ringAt(const Piece& piece, float p)
{
    const Bent outline = profileAt(piece.profile, p), axis = axisAt(piece.axis, outline.at.x);
    const float speed = glm::length(axis.slope), forth = speed * outline.slope.x;
    return {axis.at, axis.slope / speed, std::max(outline.at.y, 0.f), forth, outline.slope.y,
        (axis.slope.x * axis.bend.y - axis.slope.y * axis.bend.x) / (speed * speed * speed), std::hypot(forth, outline.slope.y)};
}

// v at each row, so that texels are square but where rings are less than half as wide as the widest.
std::vector<float> rowsOfTexture(const Piece& piece)
{
    constexpr unsigned kSteps = 16; // a row
    const auto at = [&](unsigned i) { return ringAt(piece, piece.from + (piece.to - piece.from) * float(i) / float(piece.rows * kSteps)); };
    float widest = 0.f;
    for (unsigned i = 0; i <= piece.rows * kSteps; ++i)
        widest = std::max(widest, at(i).radius);
    std::vector<float> v = {0.f};
    float sum = 0.f;
    for (unsigned i = 0; i < piece.rows * kSteps; ++i) {
        const Ring a = at(i), b = at(i + 1);
        const auto pace = [&](const Ring& ring) { return ring.pace / std::max(ring.radius, 0.5f * widest); };
        sum += 0.5f * (pace(a) + pace(b)) * (piece.to - piece.from) / float(piece.rows * kSteps) * piece.tiles / (2.f * kPi);
        if ((i + 1) % kSteps == 0)
            v.push_back(sum);
    }
    return v;
}

void addPiece(Mesh& mesh, const Piece& piece)
{
    const std::vector<float> rows = rowsOfTexture(piece);
    addGrid(mesh, piece.columns, piece.rows, [&](float s, float t) {
        const Ring ring = ringAt(piece, piece.from + (piece.to - piece.from) * t);
        const glm::vec3 turn = around(s), along(ring.along, 0.f), left(-ring.along.y, ring.along.x, 0.f);
        const bool pole = ring.radius < 1e-6f;
        const glm::vec3 out = pole ? glm::vec3(0.f) : turn.z * glm::vec3(0.f, 0.f, 1.f) + turn.x * left;
        const float outwards = ring.outwards * (1.f - ring.bend * ring.radius * turn.x);
        const float halfCell = pole ? (t < 0.5f ? 0.5f : -0.5f) / float(piece.columns) : 0.f;
        return Point{glm::vec3(ring.centre, 0.f) + ring.radius * out, glm::normalize(outwards * out - ring.onwards * along),
            {piece.tiles * (s + halfCell), rows[std::size_t(std::lround(t * float(piece.rows)))]}};
    });
}

constexpr glm::vec2 kUpright[] = {{0.f, 0.3f}, {0.f, -0.7f}};
// From the knob of the lid down to the foot.
constexpr glm::vec2 kBody[] = {{0.f, 0.f}, {0.f, 0.03f}, {0.02f, 0.055f}, {0.06f, 0.055f}, {0.08f, 0.025f}, {0.1f, 0.03f}, {0.115f, 0.08f},
    {0.135f, 0.135f}, {0.165f, 0.165f}, {0.18f, 0.165f}, {0.19f, 0.16f}, {0.21f, 0.185f}, {0.26f, 0.265f}, {0.35f, 0.31f}, {0.45f, 0.28f},
    {0.52f, 0.21f}, {0.555f, 0.185f}, {0.585f, 0.19f}, {0.59f, 0.12f}, {0.58f, 0.05f}, {0.58f, 0.f}};
constexpr glm::vec2 kSpout[] = {{0.16f, -0.18f}, {0.3f, -0.15f}, {0.4f, -0.05f}, {0.45f, 0.07f}, {0.54f, 0.12f}};
constexpr glm::vec2 kSpoutOutline[] = {{0.f, 0.f}, {0.f, 0.06f}, {0.3f, 0.085f}, {1.f, 0.078f}, {2.f, 0.058f}, {3.f, 0.044f},
    {3.7f, 0.042f}, {3.95f, 0.044f}, {4.05f, 0.038f}, {3.95f, 0.03f}, {3.7f, 0.027f}, {3.45f, 0.02f}, {3.4f, 0.01f}, {3.4f, 0.f}};
constexpr glm::vec2 kHandle[]
    = {{-0.2f, 0.08f}, {-0.32f, 0.11f}, {-0.43f, 0.1f}, {-0.49f, 0.02f}, {-0.46f, -0.1f}, {-0.37f, -0.17f}, {-0.22f, -0.2f}};
constexpr glm::vec2 kHandleOutline[] = {{0.f, 0.f}, {0.f, 0.025f}, {0.15f, 0.036f}, {1.f, 0.034f}, {2.f, 0.033f}, {3.f, 0.032f},
    {4.f, 0.031f}, {5.f, 0.03f}, {5.85f, 0.03f}, {6.f, 0.02f}, {6.f, 0.f}};
} // namespace

void makeTeapot(Mesh& mesh)
{
    constexpr float kBodyEnd = float(std::size(kBody) - 1), kSpoutEnd = float(std::size(kSpoutOutline) - 1),
                    kHandleEnd = float(std::size(kHandleOutline) - 1);
    addPiece(mesh, {kUpright, kBody, 0.f, 4.5f, 1.f, 72, 28});
    addPiece(mesh, {kUpright, kBody, 4.5f, 10.f, 3.f, 72, 32});
    addPiece(mesh, {kUpright, kBody, 10.f, kBodyEnd, 6.f, 72, 60});
    addPiece(mesh, {kSpout, kSpoutOutline, 0.f, kSpoutEnd, 2.f, 48, 96});
    addPiece(mesh, {kHandle, kHandleOutline, 0.f, kHandleEnd, 1.f, 32, 72});
    glm::vec3 least(1e9f), most(-1e9f);
    for (const Vertex& v : mesh.vertices)
        least = glm::min(least, v.position), most = glm::max(most, v.position);
    for (Vertex& v : mesh.vertices)
        v.position = (v.position - 0.5f * (least + most)) / (most.x - least.x);
}

} // namespace relievo
