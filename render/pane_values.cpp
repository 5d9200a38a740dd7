// Values of a pane, and what is left of them without relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pane_values.h"
#include "core/state/views.h"

namespace relievo {

std::set<MapKind> presentMaps(const Material& material)
{
    std::set<MapKind> maps;
    if (material.height)
        maps.insert(MapKind::Height);
    for (const MapKindRow& row : kMapKinds)
        if (material.map(row.kind))
            maps.insert(row.kind);
    return maps;
}

Parameters drawnParameters(const State& state, std::size_t pane, std::string_view view)
{
    Parameters parameters = effectiveParameters(state, pane);
    if (const ViewRow* row = findView(view); row && row->isAgainstExact)
        parameters.heightMips = false;
    return parameters;
}

ProgramFeatures withoutRelief(ProgramFeatures features)
{
    features.technique = "flat";
    features.maps.clear();
    features.curved = features.prisms = features.borders = features.depthOfHit = features.faded = features.shadows = features.softShadows
        = features.coarser = features.clamps = false;
    return features;
}

SceneUniforms withoutRelief(SceneUniforms uniforms)
{
    uniforms.reliefDepth = uniforms.pushOut = 0.f;
    return uniforms;
}

} // namespace relievo
