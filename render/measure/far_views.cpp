// Far views against supersampled ones.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/far_views.h"
#include "core/state/views.h"
#include "render/measure/picture_errors.h"
#include <cmath>

namespace relievo {

namespace {
constexpr int kFarWidth = 48, kFarHeight = 36, kFiner = 16, kFarSamples = 4; // of the reference: shifted pictures too, for slanted views
constexpr double kFarTexels[] = {1., 4., 16.}, kFarAngles[] = {30., 75.};

struct Filters {
    const char* label;
    bool textureFilter, mipMapping, heightMips;
    float anisotropy;
    NormalFiltering normals;
};
constexpr Filters kFilters[] = {
    {"none", false, false, false, 1.f, NormalFiltering::Off},
    {"texture filtering", true, false, false, 1.f, NormalFiltering::Off},
    {"mip levels", true, true, false, 1.f, NormalFiltering::Off},
    {"anisotropy 4", true, true, false, 4.f, NormalFiltering::Off},
    {"anisotropy 16", true, true, false, 16.f, NormalFiltering::Off},
    {"anisotropy 16 and coarser heights", true, true, true, 16.f, NormalFiltering::Off},
    {"the same and normals by Toksvig", true, true, true, 16.f, NormalFiltering::Toksvig},
    {"the same and normals by variance", true, true, true, 16.f, NormalFiltering::Variance},
};
constexpr const Filters& kReference = kFilters[1];

State filtered(State view, const Filters& filters)
{
    Parameters& p = view.parameters;
    p.textureFilter = filters.textureFilter, p.mipMapping = filters.mipMapping, p.heightMips = filters.heightMips;
    p.anisotropy = filters.anisotropy, p.normalFiltering = filters.normals;
    return view;
}

double luminance(const Image& image, int x, int y)
{
    return 0.2126 * double(image.value(x, y, 0)) + 0.7152 * double(image.value(x, y, 1)) + 0.0722 * double(image.value(x, y, 2));
}

// Light of kFarWidth x kFarHeight pixels, each the mean of finer x finer.
std::vector<double> lightOf(const Image& image, int finer)
{
    std::vector<double> light(std::size_t(kFarWidth) * std::size_t(kFarHeight));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            light[std::size_t(y / finer) * std::size_t(kFarWidth) + std::size_t(x / finer)]
                += luminance(image, x, y) / double(finer * finer);
    return light;
}

FarErrors errorsOf(const std::vector<double>& light, const std::vector<double>& right)
{
    double sum = 0., all = 0., squares = 0.;
    for (std::size_t i = 0; i < right.size(); ++i) {
        sum += light[i], all += right[i];
        squares += (light[i] - right[i]) * (light[i] - right[i]);
    }
    all = std::max(all, 1e-12);
    return {std::log2(std::max(sum, 1e-12) / all), std::sqrt(squares / double(right.size())) * double(right.size()) / all};
}
} // namespace

Expected<FarSection> measureFarViews(Renderer& renderer, const State& state, const Resources& given, const Progress& progress)
{
    Resources resources = fillingResources(given);
    const TechniqueRow* technique = findTechnique(state.panes.front().technique);
    if (!technique || !resources.material->height)
        return failure(state.name, "there is no technique or no height map to draw", "Assign one");
    FarSection section{state.name, std::string(technique->label), kFarWidth, kFarHeight, kFiner, {}, {}};
    const bool hasNormals = resources.material->map(MapKind::Normal) != nullptr;
    for (const Filters& filters : kFilters)
        if (hasNormals || filters.normals == NormalFiltering::Off)
            section.rows.push_back({filters.label, {}});
    for (const double angle : kFarAngles)
        for (const double texels : kFarTexels) {
            State view = fillingView(state, angle);
            view.parameters.tiling *= float(texels * kFarWidth / (double(resources.material->height->width()) * kTilesAcross));
            const auto light = [&](const Filters& filters, int finer, int samples) {
                return drawPicture(renderer, filtered(view, filters), 0, resources, knownView("shaded").key, kFarWidth * finer,
                    kFarHeight * finer, samples, true)
                    .map([finer](const Image& image) { return lightOf(image, finer); });
            };
            const auto right = light(kReference, kFiner, kFarSamples);
            if (!right)
                return tl::unexpected(right.error());
            for (std::size_t row = 0; row < section.rows.size(); ++row) {
                const auto drawn = light(kFilters[row], 1, 1);
                if (!drawn)
                    return tl::unexpected(drawn.error());
                section.rows[row].errors.push_back(errorsOf(*drawn, *right));
            }
            section.views.push_back({angle, texels});
            if (progress.cancelled())
                return cancelled("the report");
            progress.at(float(section.views.size()) / float(std::size(kFarAngles) * std::size(kFarTexels)));
        }
    return section;
}

} // namespace relievo
