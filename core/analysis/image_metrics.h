// How different two pictures look: PSNR and the FLIP difference.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include <memory>
#include <vector>

namespace relievo {

// Pictures are of one size, 3 or 4 channels U8 with display (sRGB) values; alpha does not count.

// Peak signal-to-noise ratio over the three channels, dB; infinity for equal pictures.
double psnr(const Image& a, const Image& b);

// Pixels that span a degree of the viewer's eye: 0.7 m from a monitor 0.7 m and 3840 pixels wide, as in the paper.
inline constexpr double kPixelsPerDegree = 67.;

// FLIP for pictures of low dynamic range (Andersson et al. 2020, FLIP: A Difference Evaluator for Alternating Images): for each pixel
// what a viewer notices when the two pictures alternate, 0 (nothing) to 1. Holds what depends on the reference only.
class Flip {
public:
    explicit Flip(const Image& reference, double pixelsPerDegree = kPixelsPerDegree);
    std::vector<float> map(const Image& test) const; // row-major, row 0 at the top
    double mean(const Image& test) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> m_reference;
    double m_pixelsPerDegree;
};

} // namespace relievo
