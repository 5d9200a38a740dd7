// One picture, made ready: everything that its passes read, and what an OpenGL context keeps between pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "render/draw_request.h"
#include "render/gl/program_cache.h"
#include "render/shadow_map.h"
#include "render/uploads/mesh_upload.h"
#include "render/uploads/uploads.h"
#include <map>
#include <optional>

namespace relievo {

// Uploads and programs of one context.
struct DrawContext {
    Uploads uploads;
    MeshUpload mesh;
    ProgramCache programs;
    std::map<ProgramFeatures, std::string> programNames;
    std::map<std::size_t, ShadowMap> shadowMaps; // by pane
    VertexArray noVertices;

    void forgetUploads(); // after the driver ran out of memory: the next picture tries again
    // Of the mesh with these features, and of its bare polygons. A text that does not link sets `error`; then the last good one is given.
    const LinkedProgram* meshProgramFor(const ProgramFeatures& features, std::optional<Error>& error);
    const LinkedProgram* polygonProgramFor(bool posed, std::optional<Error>& error);
};

struct Frame {
    const DrawRequest& request;
    const TechniqueRow& technique;
    const ViewRow& view;
    Parameters parameters; // of the pane, as drawn
    ProgramFeatures features = {};
    SceneUniforms uniforms = {};
    std::shared_ptr<const AccelerationMap> acceleration; // null for techniques without
    std::shared_ptr<const AccelerationMap> horizons; // null where nothing reads them
    Silhouettes curvature = Silhouettes::Off; // that the vertices carry
    bool fewerTriangles = false;
    std::optional<Error> error = {}; // of a shader that does not link, told after drawing
};

// Checks what the picture needs, and decides what it is drawn with. Needs the target bound; uploads nothing. Errors: no such view or
// technique, maps missing or not made yet, the driver's limits.
Expected<Frame> prepareFrame(DrawContext& context, const DrawRequest& request);

// Makes a program ready: its uniforms, and all that it reads bound.
void useProgram(DrawContext& context, const Frame& frame, const LinkedProgram& program, const SceneUniforms& uniforms);

} // namespace relievo
