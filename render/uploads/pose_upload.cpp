// Buffers of joints and morph targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/pose_upload.h"
#include "core/mesh/frames/curvature.h"
#include "render/gl/texture_units.h"
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <glm/vec4.hpp>
#include <vector>

namespace relievo {

std::size_t morphTexels(const Mesh& mesh)
{
    return 4 * mesh.vertices.size() * mesh.deformation->targets.size();
}

void PoseUpload::addAttributes(const Mesh& mesh)
{
    const std::vector<Influence>& influences = mesh.deformation->influences;
    m_influences = newBuffer();
    glBindBuffer(GL_ARRAY_BUFFER, *m_influences);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(influences.size() * sizeof(Influence)), influences.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(7);
    glVertexAttribIPointer(7, 4, GL_UNSIGNED_SHORT, sizeof(Influence), reinterpret_cast<const void*>(offsetof(Influence, joints)));
    glEnableVertexAttribArray(8);
    glVertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, sizeof(Influence), reinterpret_cast<const void*>(offsetof(Influence, weights)));
}

void PoseUpload::uploadTargets(BufferTexture& to, const Mesh& mesh, Silhouettes curvature)
{
    static_assert(sizeof(MorphDelta) == 3 * sizeof(glm::vec4));
    const std::vector<MorphTarget>& targets = mesh.deformation->targets;
    const std::size_t count = mesh.vertices.size();
    std::vector<glm::vec4> texels(std::max<std::size_t>(morphTexels(mesh), 1), glm::vec4(0.f));
    const std::vector<glm::vec3> rest
        = curvature != Silhouettes::Off && !targets.empty() ? vertexFalls(mesh, curvature == Silhouettes::Axes) : std::vector<glm::vec3>{};
    for (std::size_t t = 0; t < targets.size(); ++t) {
        std::vector<glm::vec3> moved;
        if (curvature != Silhouettes::Off) {
            Pose pose = bindPose(mesh);
            pose.weights[t] = 1.f;
            moved = vertexFalls(posed(mesh, pose), curvature == Silhouettes::Axes);
        }
        for (std::size_t i = 0; i < count; ++i) {
            glm::vec4* out = &texels[4 * (t * count + i)];
            std::memcpy(out, &targets[t].deltas[i], sizeof(MorphDelta));
            if (curvature != Silhouettes::Off)
                out[3] = glm::vec4(moved[i] - rest[i], 0.f);
        }
    }
    to.fill(texels, GL_STATIC_DRAW);
}

void PoseUpload::bind(const LinkedProgram& program, const Mesh& mesh, const Pose& pose, Silhouettes curvature)
{
    glActiveTexture(GL_TEXTURE0 + kPoseUnit);
    BufferTexture& morph = m_morph[curvature];
    if (!morph.texture())
        uploadTargets(morph, mesh, curvature);
    std::vector<glm::vec4> texels = {glm::vec4(float(pose.joints.size()), float(pose.weights.size()), float(mesh.vertices.size()), 0.f)};
    for (const glm::mat4& joint : pose.joints)
        for (int column = 0; column < 4; ++column)
            texels.push_back(joint[column]);
    for (const float weight : pose.weights)
        texels.emplace_back(weight, 0.f, 0.f, 0.f);
    m_pose.fill(texels, GL_STREAM_DRAW);
    program.bind("poseMap", GL_TEXTURE_BUFFER, m_pose.texture(), kPoseUnit);
    program.bind("morphMap", GL_TEXTURE_BUFFER, morph.texture(), kMorphUnit);
}

} // namespace relievo
