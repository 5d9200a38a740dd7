// Depth found against exact depth, pixel by pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/picture_errors.h"
#include "core/state/views.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {

constexpr const char* kFillingMesh = "plane";

Expected<Image> values(Renderer& renderer, const State& state, Resources& resources, std::string_view view, int width, int height)
{
    State plain = state;
    plain.parameters.wireframe = false;
    plain.parameters.heightMips = false;
    plain.parameters.background = Backdrop::Plain;
    return drawPicture(renderer, plain, 0, resources, view, width, height, 1, true);
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
    State view = ofFirstPane(state);
    view.mesh = kFillingMesh;
    view.part.clear();
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
    p.wrap = Wrap::Repeat;
    p.heightMips = p.shadows = p.wireframe = false;
    p.background = Backdrop::Plain;
    p.bloom = 0.f;
    return view;
}

Expected<PictureErrors> pictureErrors(Renderer& renderer, const State& state, Resources& resources, int width, int height)
{
    const State full = ofFirstPane(state);
    const auto difference = values(renderer, full, resources, knownView("error").key, width, height);
    if (!difference)
        return tl::unexpected(difference.error());
    const auto overshoot = values(renderer, full, resources, knownView("overshoot").key, width, height);
    if (!overshoot)
        return tl::unexpected(overshoot.error());
    const auto fetches = values(renderer, full, resources, knownView("fetches").key, width, height);
    if (!fetches)
        return tl::unexpected(fetches.error());
    PictureErrors errors;
    double pixels = 0., compared = 0.; // they differ with prisms, which the views against the exact answer do not walk
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (fetches->value(x, y, 3) != 0.f) {
                const double read = double(fetches->value(x, y, 0));
                pixels += 1.;
                errors.meanFetches += read;
                errors.maxFetches = std::max(errors.maxFetches, read);
            }
            if (difference->value(x, y, 3) != 0.f) {
                const double off = double(difference->value(x, y, 0));
                compared += 1.;
                errors.rmse += off * off;
                errors.largest = std::max(errors.largest, off);
                errors.missed += double(overshoot->value(x, y, 0)) > kMissedDepth ? 1. : 0.;
            }
        }
    errors.covered = pixels / (double(width) * double(height));
    errors.meanFetches /= std::max(pixels, 1.);
    errors.missed /= std::max(compared, 1.);
    errors.rmse = std::sqrt(errors.rmse / std::max(compared, 1.));
    return errors;
}

} // namespace relievo
