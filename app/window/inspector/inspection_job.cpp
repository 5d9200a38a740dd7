// Inspecting one point in all panes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/inspection_job.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/text.h"
#include "core/scene/picked_ray.h"
#include "core/state/techniques.h"
#include <QCoreApplication>

namespace relievo {
namespace {
QString tr(const char* text)
{
    return QCoreApplication::translate("Inspector", text);
}

Expected<SearchMaps> mapsOf(
    const TechniqueRow& technique, const Parameters& parameters, const Resources& resources, const Progress& progress)
{
    SearchMaps maps{resources.material->height->withWrap(parameters.wrap), nullptr};
    if (technique.accelerationMap.empty())
        return maps;
    if (auto made = resources.accelerationMaps.of(technique, parameters, *resources.material)) {
        maps.acceleration = *made;
        return maps;
    }
    return searchMaps(technique.key, parameters, &*maps.height, progress);
}
} // namespace

Inspected inspect(const State& state, const Resources& resources, const PickedPoint& point, const Progress& progress)
{
    if (!resources.material->height || resources.mesh->object)
        return {{}, {},
            tr(resources.mesh->object ? "A relief object has no height map to look into." : "There is no height map to look into.")};
    State asPicked = state;
    for (std::size_t i = 0; i < state.panes.size(); ++i)
        setCameraOf(asPicked, i, cameraOf(state, point.pane));
    Inspected inspected{{}, resources.material->height->withWrap(effectiveParameters(state, point.pane).wrap), {}};
    for (std::size_t i = 0; i < state.panes.size() && !progress.cancelled(); ++i) {
        const auto picked = pickedRay(asPicked, i, resources, point.at, point.aspect);
        if (!picked || picked->isPlain) {
            if (i == point.pane)
                return {{}, {}, picked ? tr("This part of the mesh has no relief.") : tr("There is no mesh at this point.")};
            continue;
        }
        const TechniqueRow& technique = *findTechnique(state.panes[i].technique);
        const Parameters parameters = effectiveParameters(state, i);
        PaneInspection pane{i, state.panes.size() > 1 ? paneLetter(i) + "  " + qt(technique.label) : qt(technique.label), {}, {}};
        const float from = float(i) / float(state.panes.size()), to = float(i + 1) / float(state.panes.size());
        if (const auto maps = mapsOf(technique, parameters, resources, progress.part(from, to))) {
            if (auto view = inspectRay(technique.key, parameters, *maps, picked->ray)) {
                if (const auto light = technique.hasShadowsAndOutlines() ? lightRayTo(*view, parameters) : std::nullopt)
                    if (auto inspection = inspectRay(technique.key, parameters, *maps, *light))
                        pane.light = std::move(*inspection);
                pane.view = std::move(*view);
            }
        }
        if (pane.view)
            inspected.panes.push_back(std::move(pane));
        if (i == point.pane && picked->bends)
            inspected.note = tr("Straight here; the picture's ray follows the bent surface.");
    }
    return inspected;
}

} // namespace relievo
