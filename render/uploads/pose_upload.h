// A deforming mesh's data in one OpenGL context: influences and morph targets once, the pose whenever it changes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/pose.h"
#include "render/gl/buffer_texture.h"
#include "render/gl/program.h"
#include <array>

namespace relievo {

// Size of morphMap.
std::size_t morphTexels(const Mesh& mesh);

class PoseUpload {
public:
    // Attributes 7 and 8 of the vertex array that is bound.
    void addAttributes(const Mesh& mesh);
    // Binds poseMap and morphMap for a program that reads them (vertex/place_posed.glsl). curvature: Axes or Quadric; Off leaves
    // what morph targets do to the curvature out.
    void bind(const LinkedProgram& program, const Mesh& mesh, const Pose& pose, Silhouettes curvature);

private:
    static void uploadTargets(BufferTexture& to, const Mesh& mesh, Silhouettes curvature);

    Buffer m_influences;
    BufferTexture m_pose;
    PerChoice<Silhouettes, BufferTexture> m_morph; // with the curvature that each reads: panes may differ
};

} // namespace relievo
