// Tags by libtiff.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/tiff_tags.h"
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <span>
#include <tiffio.h>

namespace relievo::imageio {
namespace {
// GeoTIFF 1.1, section 7.
constexpr std::uint32_t kPixelScale = 33550, kTiepoint = 33922, kTransformation = 34264, kGeoKeys = 34735, kNoDataText = 42113;
constexpr std::uint16_t kModelType = 1024, kProjectedUnits = 3076, kVerticalUnits = 4099;
constexpr std::uint16_t kGeographic = 2, kFoot = 9002, kSurveyFoot = 9003;
constexpr double kMetresPerDegree = 111320; // along the equator

int silent(TIFF*, void*, const char*, const char*, va_list)
{
    return 1; // the image library tells what it makes of the file
}

using File = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

File openTiff(const std::string& file)
{
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), silent, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), silent, nullptr);
    return {TIFFOpenExt(file.c_str(), "rM", options.get()), &TIFFClose};
}

// Tags that the library does not know come with their count.
template <class T> std::span<const T> list(TIFF* tiff, std::uint32_t tag)
{
    std::uint32_t count = 0;
    const void* values = nullptr;
    const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
    if (!field || !TIFFFieldPassCount(field) || TIFFDataWidth(TIFFFieldDataType(field)) != int(sizeof(T))
        || !TIFFGetField(tiff, tag, &count, &values) || !values)
        return {};
    return {static_cast<const T*>(values), count};
}

std::uint16_t geoKey(std::span<const std::uint16_t> keys, std::uint16_t wanted)
{
    for (std::size_t i = 4; i + 3 < keys.size(); i += 4) // after the header: key, place, count, value
        if (keys[i] == wanted && keys[i + 1] == 0)
            return keys[i + 3];
    return 0;
}

double metresOf(std::uint16_t unit)
{
    return unit == kFoot ? 0.3048 : unit == kSurveyFoot ? 1200. / 3937 : 1.;
}

// Width of a texel in the units of the map, and the latitude (or what is north) at the middle of the picture.
struct Grid {
    double width = 0, north = 0;
};
Grid gridOf(TIFF* tiff, double rows)
{
    if (const auto m = list<double>(tiff, kTransformation); m.size() >= 16)
        return {std::hypot(m[0], m[4]), m[7] + m[5] * rows / 2};
    const auto scale = list<double>(tiff, kPixelScale);
    const auto tie = list<double>(tiff, kTiepoint);
    if (scale.size() < 2)
        return {};
    return {std::abs(scale[0]), tie.size() >= 6 ? tie[4] - (rows / 2 - tie[1]) * scale[1] : 0.};
}

std::optional<Survey> surveyOf(TIFF* tiff)
{
    std::uint32_t rows = 0;
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &rows);
    const auto keys = list<std::uint16_t>(tiff, kGeoKeys);
    const auto gap = list<char>(tiff, kNoDataText);
    const Grid grid = gridOf(tiff, double(rows));
    Survey survey;
    if (std::isfinite(grid.width) && grid.width > 0)
        survey.texelWidth = geoKey(keys, kModelType) == kGeographic
            ? grid.width * kMetresPerDegree * std::max(std::cos(grid.north * std::numbers::pi / 180), 0.01)
            : grid.width * metresOf(geoKey(keys, kProjectedUnits));
    survey.metres = metresOf(geoKey(keys, kVerticalUnits));
    if (!gap.empty()) {
        const std::string text(gap.begin(), gap.end());
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (end != text.c_str())
            survey.noData = value;
    }
    return survey.texelWidth > 0 || survey.noData ? std::optional(survey) : std::nullopt;
}
} // namespace

std::optional<TiffTags> tiffTags(const std::string& file)
{
    const File tiff = openTiff(file);
    if (!tiff)
        return std::nullopt;
    TiffTags tags;
    TIFFGetField(tiff.get(), TIFFTAG_PHOTOMETRIC, &tags.photometric);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &tags.bits);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &tags.format);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &tags.samples);
    tags.survey = surveyOf(tiff.get());
    return tags;
}

} // namespace relievo::imageio
