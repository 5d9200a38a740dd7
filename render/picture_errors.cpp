// Depth found against exact depth, pixel by pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_errors.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {

constexpr const char* kFillingMesh = "plane";

Expected<Image> values(Renderer& renderer, const State& state, const Resources& resources, std::string_view view, int width, int height)
{
    State plain = state;
    plain.parameters.wireframe = false;
    plain.parameters.heightMips = false;
    plain.parameters.background = 0;
    return drawPicture(renderer, plain, 0, resources, view, width, height, 1, true);
}

// The exact depth at each pixel, from the error view of an answer that is known: without relief it is 0, and a linear search of one step
// without refinement says 1 whatever the heights. Both draw the same surface as the techniques they stand for.
Expected<Image> exactDepths(Renderer& renderer, const State& state, const Resources& resources, int width, int height)
{
    const bool displaces = findTechnique(state.panes.front().technique)->displaces;
    State known = state;
    known.panes = {Pane{displaces ? "relief" : "flat", {}}};
    known.parameters.minSteps = known.parameters.maxSteps = 1;
    known.parameters.refineSteps = 0;
    auto image = values(renderer, known, resources, "error", width, height);
    if (!image || !displaces)
        return image;
    float* value = reinterpret_cast<float*>(image->data.data());
    for (std::size_t i = 0; i < image->texelCount() * 4; i += 4)
        value[i] = 1.f - value[i];
    return image;
}

} // namespace

Resources fillingResources(Resources resources)
{
    resources.mesh = std::make_shared<const Mesh>(*openMesh(kFillingMesh));
    resources.meshName = kFillingMesh;
    return resources;
}

State fillingView(const State& state, double angle)
{
    State view = state;
    view.parameters = effectiveParameters(state, 0);
    if (!view.panes.empty())
        view.panes.front().overrides.clear();
    view.mesh = kFillingMesh;
    view.part.clear();
    view.view = "shaded";
    view.camera = Camera{};
    view.camera.yaw = 0.f;
    view.camera.pitch = float(90. - angle);
    view.camera.fov = 2.5f; // so narrow that every pixel is seen at nearly the same angle
    view.camera.distance = 1.f;
    view.camera.target = glm::vec3(0.f);
    Parameters& p = view.parameters;
    p.tiling = 16.f;
    p.midlevel = 1.f;
    p.offsetU = p.offsetV = p.rotation = p.metresPerUV = 0.f;
    p.wrap = 0;
    p.heightMips = p.shadows = p.wireframe = false;
    p.background = 0;
    return view;
}

Expected<PictureErrors> pictureErrors(Renderer& renderer, const State& state, const Resources& resources, int width, int height)
{
    State full = state;
    full.parameters = effectiveParameters(state, 0);
    full.panes = {Pane{state.panes.front().technique, {}}};
    const auto exact = exactDepths(renderer, full, resources, width, height);
    if (!exact)
        return tl::unexpected(exact.error());
    const auto found = values(renderer, full, resources, "depth", width, height);
    if (!found)
        return tl::unexpected(found.error());
    const auto fetches = values(renderer, full, resources, "fetches", width, height);
    if (!fetches)
        return tl::unexpected(fetches.error());
    PictureErrors errors;
    double pixels = 0.;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (found->value(x, y, 3) == 0.f)
                continue;
            const double difference = double(found->value(x, y, 0)) - double(exact->value(x, y, 0));
            const double read = double(fetches->value(x, y, 0));
            pixels += 1.;
            errors.meanFetches += read;
            errors.maxFetches = std::max(errors.maxFetches, read);
            errors.rmse += difference * difference;
            errors.largest = std::max(errors.largest, std::abs(difference));
            errors.missed += difference > kMissedDepth ? 1. : 0.;
        }
    errors.covered = pixels / (double(width) * double(height));
    pixels = std::max(pixels, 1.);
    errors.meanFetches /= pixels;
    errors.missed /= pixels;
    errors.rmse = std::sqrt(errors.rmse / pixels);
    return errors;
}

} // namespace relievo
