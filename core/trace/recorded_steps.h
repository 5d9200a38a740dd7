// The steps that a search takes along one ray, as the text of its technique tells them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/trace/shader_on_cpu.h"
#include <string_view>
#include <vector>

namespace relievo {

enum class StepKind { Linear, Halving, Secant, Cone, Box, Cell, Ball, Offset };
constexpr std::string_view wordOf(StepKind kind)
{
    switch (kind) {
    case StepKind::Linear:
        return "linear";
    case StepKind::Halving:
        return "halving";
    case StepKind::Secant:
        return "secant";
    case StepKind::Cone:
        return "cone";
    case StepKind::Box:
        return "box";
    case StepKind::Cell:
        return "cell";
    case StepKind::Ball:
        return "ball";
    case StepKind::Offset:
        return "offset";
    }
    return {};
}

// From where the step before ended, in t, to where it reads or leaps to; of a halving the bracket that it leaves. A step of no length is a
// read at the start.
struct SearchStep {
    StepKind kind = StepKind::Linear;
    double from = 0., to = 0.;
    glm::dvec2 uv{0.}; // where it ends; of a halving its middle, of an offset where it was read
    double height = 0.; // bilinear, there; 0 without a height map
    int fetches = 0;
};

// What the lines `record...` in shaders/ call on the CPU: in all other programs they are left out (core/shader_text/assembly.cpp).
class StepRecorder {
public:
    explicit StepRecorder(const SearchRay& ray) : m_ray(ray) { }

    void step(StepKind kind, float to, int reads); // ends at `to`, after so many reads of the whole search
    void halving(float from, float to, float middle, int reads); // leaves [from, to] of its bracket
    void read(StepKind kind, int reads); // at the end of the step before, or at the start
    void share(float share) { m_share = double(share); } // what follows counts t in a part of the ray's way (engines march so)
    // The steps of a search that found `hit`: they end at its t, and their fetches are its.
    std::vector<SearchStep> finish(const SearchHit& hit, const HeightField* field) &&;

private:
    glm::dvec2 at(double t) const { return m_ray.uv + t * m_ray.duv; }

    SearchRay m_ray;
    std::vector<SearchStep> m_steps;
    double m_share = 1.;
    int m_reads = 0; // that steps have
};

// Runs technique `key` as traceRays does, and tells its steps. Bump and flat take none; the reference is one cell.
struct RecordedSearch {
    SearchHit hit;
    std::vector<SearchStep> steps;
};
Expected<RecordedSearch> recordSearch(std::string_view key, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray);

} // namespace relievo
