// Uniforms by their tables.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/uniform_values.h"
#include "core/shader_text/scene_uniforms.h"

namespace relievo {

WebJson uniformValues(const Parameters& ofPane, const TechniqueRow& technique, const ExportJob& job)
{
    const Parameters parameters = withOneDirectional(ofPane); // as exportedFeatures
    WebJson uniforms;
    for (const ParameterRow& row : kParameters)
        uniforms[std::string(row.key)] = std::visit([](auto value) { return jsonOf(value); }, get(parameters, row));
    const Mesh& mesh = *job.resources.mesh;
    SceneUniforms scene = sceneUniforms(parameters, cameraOnto(mesh, cameraOf(job.state, 0), 1.f), mesh.metresPerUV);
    scene.pushOut = technique.displaces ? (1.f - parameters.midlevel) * scene.reliefDepth : 0.f;
    for (const SceneUniformRow& row : kSceneUniforms)
        std::visit(
            [&](auto member) {
                if constexpr (!std::is_same_v<decltype(member), decltype(&SceneUniforms::lights)>) // no exported program has several
                    uniforms[std::string(row.name)] = jsonOf(scene.*member);
            },
            row.member);
    return uniforms;
}

} // namespace relievo
