// Conventions of a set's maps, from their pixels where these speak, else from their names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/sets/texture_set.h"

namespace relievo {

// What the names claim; Unsure where they do not.
struct NamedConventions {
    Convention height = Convention::Unsure; // Height or Depth
    Convention normal = Convention::Unsure; // GL or DX
    Convention heightOtherwise = Convention::Height; // where neither name nor pixels speak
};

// Fills channel (Rgb becomes R for grey scalar maps), convention, min and max of every map from set.images, and tells what is
// converted, guessed or contradictory.
void measureMaps(TextureSet& set, const NamedConventions& named);

} // namespace relievo
