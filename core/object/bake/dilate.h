// Filling what a picture leaves empty from what lies around.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <glm/vec4.hpp>
#include <vector>

namespace relievo {

// Row-major values, and how much of each texel they fill: 0 or more. Those that are filled stay; all others become means of the coarser
// copies of the picture that reach there, so that no smaller mip level mixes in what is not there. All zero where nothing is filled.
void dilate(std::vector<glm::vec4>& values, const std::vector<float>& filled, int width, int height);

} // namespace relievo
