// Rays in and hits out as CSV (resources/help/command-line.md, "Rays and hits").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/trace/ray.h"
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace relievo::cli {

struct RaysRead {
    std::vector<SearchRay> rays;
    Warnings warnings; // "cosine-range": values of cosView outside (0, 1], which are brought into it
};
// |N.V| of a ray whose relief is so deep (share of the tile): depth / sqrt(depth^2 + |duv|^2), 1 where that is 0 / 0, at least 1e-6.
double cosineOf(const SearchRay& ray, double depth);
// Header u,v,du,dv[,cosView]. Without cosView: depth / sqrt(depth^2 + |duv|^2), 1 where that is 0 / 0.
// Errors name file and line. "nan" and "inf" are numbers here: such a ray is answered, not refused.
Expected<RaysRead> readRays(const std::filesystem::path& file, double depth);

// hit,t,u,v,fetches and one line a hit; numbers read back exactly.
std::string hitsText(std::span<const SearchHit> hits);

} // namespace relievo::cli
