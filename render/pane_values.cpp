// Values of a pane, and what is left of them without relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pane_values.h"

namespace relievo {

Parameters drawnParameters(const State& state, std::size_t pane, const TechniqueRow& technique, const ViewRow& view)
{
    Parameters parameters = effectiveParameters(state, pane);
    if (view.isAgainstExact || technique.isEngine())
        parameters.heightMips = false;
    return parameters;
}

ProgramFeatures intoShadowMap(ProgramFeatures features, const TechniqueRow& technique)
{
    features.view = knownView("depth").key;
    for (const ParameterRow& row : kParameters) // nothing is lit or shown
        if (row.shader.place != ShaderPlace::Surface)
            features.setVariant(row.member, 0);
    features.shadows = features.softShadows = features.horizonShadows = features.severalLights = features.objectShadows = features.glows
        = false;
    features.setVariant(&Parameters::edgeFade, 0); // by the eye's view, not the light's
    features.setVariant(&Parameters::depthOfHit, technique.displaces ? 1 : 0);
    return features;
}

ProgramFeatures withoutRelief(ProgramFeatures features)
{
    features.technique = knownTechnique("flat").key;
    features.maps = {};
    features.curved = features.prisms = features.borders = features.coarser = features.clamps = false;
    features.shadows = features.softShadows = features.horizonShadows = false;
    features.setVariant(&Parameters::depthOfHit, 0);
    features.setVariant(&Parameters::edgeFade, 0);
    features.setVariant(&Parameters::normalFiltering, 0); // there is no normal map
    features.setVariant(&Parameters::ambientRelief, 0);
    features.setVariant(&Parameters::specularOcclusion, 0);
    return features;
}

SceneUniforms withoutRelief(SceneUniforms uniforms)
{
    uniforms.reliefDepth = uniforms.pushOut = 0.f;
    return uniforms;
}

} // namespace relievo
