// The maps of a material as exporters want them: sizes, precisions and packings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"

namespace relievo {

// All zero.
Image emptyImage(int width, int height, int channels, PixelType type);
// Sets one channel of one texel, rounded to what the image holds; integers take [0, 1].
void store(Image& image, int x, int y, int channel, float value);
// Bilinear between texel centres, the image repeated: maps of one material may differ in size.
float sampled(const Image& image, float u, float v, int channel);

// How the numbers of an image are averaged when it is reduced.
enum class Averaging { Plain, Srgb, Normals };

// Heights as large as they are written, of 16 bits then: maps that are baked of them fit what lies beside them.
HeightField asLargeAsWritten(const HeightField& field, int size);

// Box-reduced so that its longest side is `size` texels; an image that is not larger (or size 0) comes back as it is.
// Srgb: averaged as light (F32 is linear already). Normals: made unit again.
Image reduced(const Image& image, int size, Averaging averaging);

// 8 bits a channel. srgb: F32 values are linear and become encoded; integers stay what they are.
Image eightBit(const Image& image, bool srgb);

// Heights as one channel of 8, 16 or 32 bits (float).
Image heightImage(const HeightField& field, int bits);

// Base colour with opacity as alpha (3 channels when there is none), 8 bits sRGB; nothing when the material has neither. Where it has no
// colour the pixels are white: the exporter's factor is kColorWithoutMap then.
std::optional<Image> baseColorImage(const Material& material, int size);

// glTF's packing, 8 bits: red occlusion, green roughness, blue metallic; a missing map is 1 (metallic: 0). Nothing when all are.
std::optional<Image> packedImage(const Material& material, int size);

// The set's normal map, or one made from height at the parameters' depth (16 bits); nothing without either.
std::optional<Image> normalImage(const Material& material, const Parameters& parameters, const Progress& progress);

// The largest value of an image; of integers at most 1.
float brightest(const Image& image);

// The double of the shortest decimal that is this float, so that files say 0.028 and not 0.02800000086426735.
double shortest(float value);

// A file name without characters that systems or shells trip over; letters of any script stay. Never empty.
std::string fileStem(const std::string& name);

} // namespace relievo
