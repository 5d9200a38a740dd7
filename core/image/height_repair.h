// Making heights out of an image's channel: finite, in [0, 1], white high.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/state/map_slots.h"
#include <optional>
#include <string>
#include <vector>

namespace relievo {

// Replaces NaN and infinities by the mean of their finite neighbours, gaps from their rim inwards; deeper than kRepairedRims texels
// by the mean of the channel (0 when nothing of it is finite). Values are width * height * channels. Returns how many there were.
inline constexpr int kRepairedRims = 16;
std::size_t repairNonFinite(std::vector<float>& values, int width, int height, int channels);

// The channel as floats: integers / maximum, Rgb as the mean of three.
std::vector<float> scalarValues(const Image& image, Channel channel);

// What loading will do to these values, in the user's words: "nan-repaired", "height-range". `file` stands in the text.
struct ScalarTrouble {
    std::size_t nonFinite = 0;
    double low = 0, high = 1; // of the finite values
    bool leavesRange() const { return low < 0 || high > 1; }
};
ScalarTrouble scalarTrouble(const Image& image, Channel channel);
Warnings warningsOf(const ScalarTrouble& trouble, const std::string& file);

// Repaired, mapped from min..max when a float map leaves [0, 1], and flipped when `invert`.
std::vector<float> soundScalars(const Image& image, Channel channel, bool invert);

} // namespace relievo
