// Why a search found what it found along one ray: its steps beside the exact hit, and a sentence.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/trace/recorded_steps.h"
#include <string>

namespace relievo {

struct RayInspection {
    std::string technique; // key
    SearchRay ray;
    std::vector<SearchStep> steps;
    SearchHit hit;
    double exact = 1.; // t of the first hit of the bilinear surface (core/trace/exact_search.h); 1: the floor
    std::string verdict; // one sentence: right, or where and why not
};

// Errors: those of recordSearch; there is no height map.
Expected<RayInspection> inspectRay(std::string_view technique, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray);

// The ray of light that comes to the point where `view` has hit, on the flat plane, from where it enters the relief; its search ends at the
// point. Nothing when the light is under the horizon, or the point on the surface.
std::optional<SearchRay> lightRayTo(const RayInspection& view, const Parameters& parameters);

// As `relievo inspect --json` prints it (resources/help/command-line.md, "Steps of a ray").
std::string inspectionJson(const RayInspection& inspection);
// One line a step, with a header: kind,from,to,u,v,height,fetches.
std::string inspectionCsv(const RayInspection& inspection);

} // namespace relievo
