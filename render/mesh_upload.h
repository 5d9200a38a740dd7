// The mesh in one OpenGL context: its vertices, and what more of it a program reads, each made when first needed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "render/pose_upload.h"
#include <memory>
#include <optional>
#include <string_view>

namespace relievo {

class MeshUpload {
public:
    // Forgets what belongs to another mesh.
    void hold(const std::shared_ptr<const Mesh>& mesh);

    // isClosed and whether bordersOf finds any; for silhouettes.
    bool isClosed();
    bool hasBorders();

    // Binds the pose that clip and time name, and the borders, for a program that reads them.
    void bind(const LinkedProgram& program, const Parameters& parameters);

    // Which parts of the mesh a draw is for: those with the relief of the material, or those without any. `part` is State::part.
    enum class Parts { Relief, Plain };
    bool has(Parts parts, std::string_view part) const;
    // Draws their triangles. Attribute locations are those of the vertex stage's files.
    // pushed: with the directions of core/mesh/push.h, which are made only then. curvature: the parameter `silhouettes`; 0 wants none.
    void draw(const LinkedProgram& program, Parts parts, std::string_view part, bool pushed, int curvature);

private:
    void makeVertices();

    std::shared_ptr<const Mesh> m_mesh;
    VertexArray m_vertexArray;
    Buffer m_vertices, m_indices, m_push, m_curvature;
    int m_curvatureKind = 0; // of what lies in m_curvature
    std::optional<bool> m_closed;
    std::optional<BufferTexture> m_borders; // without a texture when the mesh has none
    PoseUpload m_pose;
};

} // namespace relievo
