// Making heights out of an image's channel: finite, in [0, 1], white high.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/height_codes.h"
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

// What becomes of finite values outside [0, 1].
enum class Beyond {
    Rescaled, // heights: mapped from min..max, unless they leave [0, 1] by a hundredth of their range at most: then clamped
    Clamped, // roughness, occlusion ...: their values mean something by themselves
};

// The pixels and the channel that heights are read from: decoded where they are packed as a code, in the file's own numbers where they are
// whole numbers with tags of an elevation model. Lives no longer than `image`.
class HeightPixels {
public:
    HeightPixels(const Image& image, Channel wanted);
    const Image& image() const { return m_made ? *m_made : *m_given; }
    Channel channel() const { return m_channel; }
    HeightCode code() const { return m_code; }

private:
    const Image* m_given;
    std::optional<Image> m_made;
    Channel m_channel;
    HeightCode m_code;
};

// What loading will do to these values, in the user's words: "nan-repaired", "no-data", "height-range", "value-range", "channels-differ",
// "narrow-range".
struct ScalarTrouble {
    std::size_t nonFinite = 0;
    std::size_t noData = 0; // elevation's -9999, -32768 or -1e30 and less, far below all other values: filled like NaN
    double low = 0, high = 1; // of the other values
    bool wholeNumbers = false; // integers of 32 bits or with gaps: a count or elevation, never meant as shares of the largest number
    bool differ = false; // red, green and blue differ, and their mean is taken
    double maximum = 1; // the file's number that 1 stands for
    double largest = 0; // number that whole numbers of this kind can have, 0 for floats
    Beyond beyond = Beyond::Rescaled;
    bool leavesRange() const { return low < 0 || high > 1; }
    bool rescales() const; // false: what leaves the range is clamped
    bool narrow() const; // whole heights that use less than a twentieth of their numbers
    std::optional<double> zero() const; // where the zero of signed heights comes to lie when they are rescaled
};
ScalarTrouble scalarTrouble(const Image& image, Channel channel, Beyond beyond = Beyond::Rescaled);
// `file` stands in the texts.
Warnings warningsOf(const ScalarTrouble& trouble, const std::string& file);
// Those of its ScalarTrouble, and "packed-heights".
Warnings warningsOf(const HeightPixels& pixels, const std::string& file);

// Repaired, brought into [0, 1] as `beyond` says (floats only), and flipped when `invert`. Integers are as stored.
std::vector<float> soundScalars(const Image& image, Channel channel, bool invert, Beyond beyond = Beyond::Rescaled);

} // namespace relievo
