// Repairing and rescaling float maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_repair.h"
#include "core/image/pixels.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <oneapi/tbb/parallel_for.h>
#include <tuple>

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

std::string rounded(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
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

namespace {
// Finite minimum and maximum of the values above `floor`; (0, 0) without any.
std::pair<double, double> rangeAbove(const std::vector<float>& values, double floor)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const float value : values)
        if (std::isfinite(value) && double(value) > floor) {
            low = std::min(low, double(value));
            high = std::max(high, double(value));
        }
    return low <= high ? std::pair(low, high) : std::pair(0., 0.);
}

std::size_t countUpTo(const std::vector<float>& values, double floor)
{
    return std::size_t(std::ranges::count_if(values, [=](float v) { return std::isfinite(v) && double(v) <= floor; }));
}

// Elevation files mark gaps by a number far below all heights. Returns the largest value that stands for one; -infinity: there is none.
double noDataFloor(const std::vector<float>& values, const Image& image)
{
    const bool whole = !image.storedFloat && !image.survey; // signed integers arrive divided by their largest
    const double unit = !whole ? 1 : image.storedMaximum > 0 ? image.storedMaximum : image.storedBits <= 16 ? 32767 : 2147483647;
    const double lowest = rangeAbove(values, -HUGE_VAL).first;
    const auto is = [&](double mark) { return std::abs(lowest * unit - mark) <= 1e-6 * std::abs(mark) + (whole ? 0.5 : 0); };
    const bool huge = lowest <= -1e30;
    if (!huge && !is(-9999) && !is(-32768) && !is(-32767))
        return -HUGE_VAL;
    const double floor = huge ? -1e30 : lowest;
    const auto [low, high] = rangeAbove(values, floor);
    return low - floor > high - low && countUpTo(values, floor) < values.size() ? floor : -HUGE_VAL;
}

// Those that the file's own tag names. A mark of 1e38 may have lost digits.
std::size_t clearNoData(std::vector<float>& values, const Image& image)
{
    if (!image.survey || !image.survey->noData)
        return 0;
    const double mark = *image.survey->noData / (image.storedMaximum > 0 ? image.storedMaximum : 1);
    std::size_t count = 0;
    for (float& value : values)
        if (std::abs(double(value) - mark) <= 1e-6 * std::abs(mark) || (std::isnan(mark) && std::isnan(value))) {
            value = NAN;
            ++count;
        }
    return count;
}

// The channel of a float image with its gaps as NaN.
std::vector<float> gappedScalars(const Image& image, Channel channel, ScalarTrouble& trouble)
{
    std::vector<float> values = scalarValues(image, channel);
    trouble.noData = clearNoData(values, image);
    trouble.nonFinite = std::size_t(std::ranges::count_if(values, [](float v) { return !std::isfinite(v); })) - trouble.noData;
    if (const double floor = noDataFloor(values, image); std::isfinite(floor)) {
        trouble.noData += countUpTo(values, floor);
        for (float& value : values)
            if (double(value) <= floor)
                value = NAN;
    }
    std::tie(trouble.low, trouble.high) = rangeAbove(values, -HUGE_VAL);
    trouble.wholeNumbers = !image.storedFloat && (image.storedBits == 32 || trouble.noData > 0 || image.survey);
    return values;
}

// In the file's own numbers, so that its marks and messages are in them too.
Image ownNumbers(const Image& image)
{
    Image own{image.width, image.height, image.channels, PixelType::F32, image.storedBits, false, {}};
    own.survey = image.survey;
    own.data.resize(image.data.size() / bytesOf(image.type) * sizeof(float));
    float* out = reinterpret_cast<float*>(own.data.data());
    withTexels(image, [&](const auto* texels, float) {
        const std::size_t count = image.data.size() / bytesOf(image.type);
        const double unit = image.type == PixelType::F32 ? image.storedMaximum : 1;
        for (std::size_t i = 0; i < count; ++i)
            out[i] = std::is_integral_v<std::remove_cvref_t<decltype(*texels)>> ? float(texels[i])
                                                                                : std::round(float(double(texels[i]) * unit));
    });
    return own;
}

std::string texels(std::size_t count)
{
    return std::to_string(count) + (count == 1 ? " texel" : " texels");
}
} // namespace

HeightPixels::HeightPixels(const Image& image, Channel wanted) : m_given(&image), m_channel(wanted), m_code(heightCodeOf(image, wanted))
{
    if (m_code != HeightCode::None)
        m_made = decodedHeights(image, m_code);
    else if (image.survey && !image.storedFloat)
        m_made = ownNumbers(image);
    m_channel = m_code != HeightCode::None ? Channel::R : scalarChannel(image, wanted);
}

bool ScalarTrouble::rescales() const
{
    constexpr double kSlight = 0.01; // of the range: what resampling overshoots
    if (beyond == Beyond::Clamped)
        return false;
    return wholeNumbers || std::max(-low, high - 1) > kSlight * (high - low);
}

bool ScalarTrouble::narrow() const
{
    constexpr double kNarrow = 0.05;
    return beyond == Beyond::Rescaled && largest > 0 && !rescales() && high > low && high - low < kNarrow;
}

std::optional<double> ScalarTrouble::zero() const
{
    return rescales() && low < 0 && high > 0 ? std::optional(-low / (high - low)) : std::nullopt;
}

ScalarTrouble scalarTrouble(const Image& image, Channel channel, Beyond beyond)
{
    ScalarTrouble trouble;
    trouble.beyond = beyond;
    trouble.differ = channel == Channel::Rgb && !looksGrey(image);
    if (image.type == PixelType::F32) {
        gappedScalars(image, channel, trouble);
        trouble.largest = image.storedMaximum;
    } else if (beyond == Beyond::Rescaled) {
        std::tie(trouble.low, trouble.high) = rangeOf(image, channel);
        trouble.largest = image.type == PixelType::U8 ? 255 : 65535;
    }
    trouble.maximum = trouble.largest > 0 ? trouble.largest : 1;
    return trouble;
}

Warnings warningsOf(const ScalarTrouble& trouble, const std::string& file)
{
    Warnings warnings;
    const std::string range = number(trouble.low * trouble.maximum) + " .. " + number(trouble.high * trouble.maximum);
    if (trouble.differ)
        warnings.push_back({"channels-differ",
            file + ": its red, green and blue differ, and their mean is used: choose one channel, as in " + file
                + "#r, or take it as the color map"});
    if (trouble.nonFinite > 0)
        warnings.push_back({"nan-repaired",
            file + ": " + texels(trouble.nonFinite) + (trouble.nonFinite == 1 ? " is" : " are")
                + " not a number or infinite: replaced by the neighbours' mean"});
    if (trouble.noData > 0)
        warnings.push_back({"no-data", file + ": " + texels(trouble.noData) + " without data: replaced by the neighbours' mean"});
    if (trouble.rescales()) {
        const std::optional<double> zero = trouble.zero();
        warnings.push_back({"height-range",
            file + (trouble.leavesRange() && !trouble.wholeNumbers ? ": its values leave 0..1" : ": its values are whole numbers")
                + ": mapped from " + range + (zero ? ", its zero is at midlevel " + rounded(*zero) : "")});
    } else if (trouble.leavesRange())
        warnings.push_back({"value-range", file + ": its values leave 0..1 (" + range + "): clamped"});
    if (trouble.narrow())
        warnings.push_back({"narrow-range",
            file + ": it uses only " + range + " of 0 .. " + number(trouble.largest)
                + ", so the relief is that much flatter: save it as 32-bit float TIFF or EXR, which is stretched, or stretch it before"});
    return warnings;
}

Warnings warningsOf(const HeightPixels& pixels, const std::string& file)
{
    Warnings warnings;
    if (pixels.code() != HeightCode::None)
        warnings.push_back({"packed-heights", file + ": its heights are packed " + std::string(nameOf(pixels.code())) + ": decoded"});
    for (Warning& warning : warningsOf(scalarTrouble(pixels.image(), pixels.channel()), file))
        warnings.push_back(std::move(warning));
    return warnings;
}

std::vector<float> soundScalars(const Image& image, Channel channel, bool invert, Beyond beyond)
{
    double low = 0, span = 1;
    std::vector<float> values;
    if (image.type == PixelType::F32) {
        ScalarTrouble trouble;
        trouble.beyond = beyond;
        values = gappedScalars(image, channel, trouble);
        if (trouble.nonFinite + trouble.noData > 0)
            repairNonFinite(values, image.width, image.height, 1);
        if (trouble.rescales()) {
            low = trouble.low;
            span = trouble.high > trouble.low ? trouble.high - trouble.low : 1;
        }
    } else
        values = scalarValues(image, channel);
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
