// Repairing and rescaling float maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_repair.h"
#include "core/image/pixels.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {
namespace {
// Mean of the finite ones among the eight neighbours of (x, y); not a number without any.
float neighbourMean(const std::vector<float>& values, int width, int height, int channels, int x, int y, int c)
{
    double sum = 0;
    int count = 0;
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
            const float value = values[(std::size_t(j) * std::size_t(width) + std::size_t(i)) * std::size_t(channels) + std::size_t(c)];
            if (std::isfinite(value)) {
                sum += double(value);
                ++count;
            }
        }
    return count > 0 ? float(sum / count) : NAN;
}

// Mean of the channel's finite values; 0 without any.
float finiteMean(const std::vector<float>& values, std::size_t channels, std::size_t c)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = c; i < values.size(); i += channels)
        if (std::isfinite(values[i])) {
            sum += double(values[i]);
            ++count;
        }
    return count > 0 ? float(sum / double(count)) : 0.f;
}

// Repairs those of `gaps` that have finite neighbours, from the values before; returns the others.
std::vector<std::size_t> repairRim(std::vector<float>& values, const std::vector<std::size_t>& gaps, int width, int height, int channels)
{
    std::vector<std::pair<std::size_t, float>> repairs;
    std::vector<std::size_t> inner;
    const std::size_t rowValues = std::size_t(width) * std::size_t(channels);
    for (const std::size_t i : gaps) {
        const int y = int(i / rowValues), x = int(i % rowValues) / channels, c = int(i % std::size_t(channels));
        const float mean = neighbourMean(values, width, height, channels, x, y, c);
        if (std::isfinite(mean))
            repairs.emplace_back(i, mean);
        else
            inner.push_back(i);
    }
    for (const auto& [at, value] : repairs)
        values[at] = value;
    return inner;
}

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}
} // namespace

std::size_t repairNonFinite(std::vector<float>& values, int width, int height, int channels)
{
    std::vector<std::size_t> gaps;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            gaps.push_back(i);
    const std::size_t count = gaps.size();
    for (int rim = 0; rim < kRepairedRims && !gaps.empty(); ++rim) {
        std::vector<std::size_t> inner = repairRim(values, gaps, width, height, channels);
        if (inner.size() == gaps.size())
            break;
        gaps = std::move(inner);
    }
    if (gaps.empty())
        return count;
    std::vector<float> means;
    for (std::size_t c = 0; c < std::size_t(channels); ++c)
        means.push_back(finiteMean(values, std::size_t(channels), c));
    for (const std::size_t i : gaps)
        values[i] = means[i % std::size_t(channels)];
    return count;
}

std::vector<float> scalarValues(const Image& image, Channel channel)
{
    std::vector<float> values(image.texelCount());
    const auto [first, last] = channelRange(image, channel);
    const std::size_t channels = std::size_t(image.channels), begin = std::size_t(first), count = std::size_t(last - first);
    withTexels(image, [&](const auto* texels, float maximum) {
        oneapi::tbb::parallel_for(0, image.height, [&](int y) {
            const std::size_t from = std::size_t(y) * std::size_t(image.width), to = from + std::size_t(image.width);
            if (count == 1)
                for (std::size_t i = from; i < to; ++i)
                    values[i] = float(texels[i * channels + begin]) / maximum;
            else
                for (std::size_t i = from; i < to; ++i)
                    values[i] = (float(texels[i * channels]) + float(texels[i * channels + 1]) + float(texels[i * channels + 2]))
                        / (3.f * maximum);
        });
    });
    return values;
}

ScalarTrouble scalarTrouble(const Image& image, Channel channel)
{
    ScalarTrouble trouble;
    if (image.type != PixelType::F32)
        return trouble;
    const std::vector<float> values = scalarValues(image, channel);
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const float value : values) {
        if (!std::isfinite(value)) {
            ++trouble.nonFinite;
            continue;
        }
        low = std::min(low, double(value));
        high = std::max(high, double(value));
    }
    trouble.low = low <= high ? low : 0;
    trouble.high = low <= high ? high : 0;
    return trouble;
}

Warnings warningsOf(const ScalarTrouble& trouble, const std::string& file)
{
    Warnings warnings;
    if (trouble.nonFinite > 0)
        warnings.push_back({"nan-repaired",
            file + ": " + std::to_string(trouble.nonFinite) + (trouble.nonFinite == 1 ? " texel is" : " texels are")
                + " not a number or infinite: replaced by the neighbours' mean"});
    if (trouble.leavesRange())
        warnings.push_back(
            {"height-range", file + ": its values leave 0..1: mapped from " + number(trouble.low) + " .. " + number(trouble.high)});
    return warnings;
}

std::vector<float> soundScalars(const Image& image, Channel channel, bool invert)
{
    std::vector<float> values = scalarValues(image, channel);
    double low = 0, span = 1;
    if (image.type == PixelType::F32) {
        const ScalarTrouble trouble = scalarTrouble(image, channel);
        if (trouble.nonFinite > 0)
            repairNonFinite(values, image.width, image.height, 1);
        if (trouble.leavesRange()) {
            low = trouble.low;
            span = trouble.high > trouble.low ? trouble.high - trouble.low : 1;
        }
    }
    const bool rescale = low != 0 || span != 1;
    oneapi::tbb::parallel_for(0, image.height, [&](int y) {
        const std::size_t from = std::size_t(y) * std::size_t(image.width), to = from + std::size_t(image.width);
        for (std::size_t i = from; i < to; ++i) {
            const float value = std::clamp(rescale ? float((double(values[i]) - low) / span) : values[i], 0.f, 1.f);
            values[i] = invert ? 1.f - value : value;
        }
    });
    return values;
}

} // namespace relievo
