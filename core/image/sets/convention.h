// Measuring how normal and height maps are to be read: by their pixels, not by their names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/state/map_slots.h"

namespace relievo {

// How a normal map stores its vector.
enum class NormalLayout {
    Xyz, // in red, green, blue
    Xy, // red and green; blue says nothing or something else, z is rebuilt
    AlphaGreen, // x in alpha, y in green (compressed "DXT5nm"), z is rebuilt
};
NormalLayout normalLayout(const Image& image, bool namedRelief = false); // namedRelief: see reliefForm

// Share of texels whose red, green and blue are a unit vector pointing out of the surface.
double unitShare(const Image& image);

// Pearson correlations over a common grid, at the finer or coarser scale, whichever is clearer; 0 where one does not vary.
struct Agreement {
    double red = 0; // of red with dh/dx: negative for a height map, positive for a depth map
    double green = 0; // of green with dh/dy, y down: the opposite sign of red in OpenGL style, the same in DirectX style
};
Agreement slopeAgreement(const Image& normal, const Image& height, Channel heightChannel);

// Without a height map: slopes of one surface have equal mixed derivatives. In [-1, 1]: positive is OpenGL, negative DirectX,
// near 0 says nothing (surfaces without diagonal slopes).
double handedness(const Image& normal);

// How clear an agreement is, in [0, 1]: the geometric mean of both directions, or the one direction that varies at all.
double clarity(const Agreement& agreement);
// Below this the evidence is called weak. Measured: maps of one material 0.46 and more, of different materials 0.26 and less.
inline constexpr double kClearAgreement = 0.3;
inline constexpr double kClearHandedness = 0.2;

// The papers' relief textures.
enum class ReliefForm {
    None,
    NormalAndDepth, // normal in r g b, height or depth in a
    Dual, // normal x y in r g, back depth in b, front depth in a
};
// named: the file's name promises a relief texture, so weaker evidence suffices.
ReliefForm reliefForm(const Image& image, bool named);

} // namespace relievo
