// The mesh in one OpenGL context: its vertices, and what more of it a program reads, each made when first needed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/pose.h"
#include "render/uploads/object_upload.h"
#include "render/uploads/pose_upload.h"
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo {

class MeshUpload {
public:
    // Forgets what belongs to another mesh.
    void show(const std::shared_ptr<const Mesh>& mesh);

    bool hasBorders(); // whether bordersOf finds any
    // Whether faces away from `eye` may be seen though the fronts cover what lies behind them: not those of a closed mesh, unless the eye
    // may be inside. margin: how far the mesh is pushed out, m.
    bool showsBacks(glm::vec3 eye, float margin);
    bool isFinerThanPixels() const; // has more triangles than the viewport has pixels: drawing it costs more than searching what is hidden
    bool hasPrisms(); // whether the driver's buffers are large enough for the mesh

    // Binds the pose that clip and time name, the borders and the prisms, for a program that reads them. part: State::part. curvature: as
    // of draw().
    void bind(const LinkedProgram& program, const Parameters& parameters, std::string_view part, Silhouettes curvature);

    // Which parts of the mesh a draw is for: those with the relief of the material, or those without any. `part` is State::part.
    enum class Parts { Relief, Plain };
    bool has(Parts parts, std::string_view part) const;
    // Draws their triangles. Attribute locations are those of the vertex stage's files.
    // pushed: with the directions of core/mesh/frames/push.h, which are made only then. curvature: Axes or Quadric; Off wants
    // none. coarse: fewer triangles (core/mesh/edges/coarse.h), for programs that read nothing by triangle.
    void draw(const LinkedProgram& program, Parts parts, std::string_view part, bool pushed, Silhouettes curvature, bool coarse);

private:
    void makeVertices();
    void makeCoarse();
    void bindPrisms(const LinkedProgram& program, const Pose& pose, std::string_view part);

    std::shared_ptr<const Mesh> m_mesh;
    VertexArray m_vertexArray;
    Buffer m_vertices, m_indices, m_push, m_coarse;
    PerChoice<Silhouettes, Buffer> m_curvature; // panes may differ
    std::vector<std::uint32_t> m_coarseFirst; // CoarseTriangles::firstIndex
    std::optional<bool> m_closed;
    std::optional<BufferTexture> m_borders; // without a texture when the mesh has none
    BufferTexture m_prisms;
    std::optional<std::pair<Pose, std::string>> m_prismsAre; // of this pose and part
    std::vector<std::uint32_t> m_across; // core/mesh/edges/across.h
    PoseUpload m_pose;
    ObjectUpload m_object;
};

} // namespace relievo
