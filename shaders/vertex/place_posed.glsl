// A vertex as the pose has it: morph targets added, then moved by the joints that hold it (glTF 2.0, sections 3.7.2.2 and 3.7.3.3). Frame,
// Jacobian and curvature follow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "vertex/placed.glsl"
layout(location = 7) in uvec4 vertexJoints;
layout(location = 8) in vec4 vertexWeights;

// poseMap: (joints, targets, vertices, 0), then four columns a joint, then a weight a target. morphMap: four texels a vertex and target.
mat4 jointMatrix(uint joint)
{
    int at = 1 + 4 * int(joint);
    return mat4(texelFetch(poseMap, at), texelFetch(poseMap, at + 1), texelFetch(poseMap, at + 2), texelFetch(poseMap, at + 3));
}

Placed placed()
{
    Placed at = Placed(vertexPosition, vertexNormal, vertexPush, vertexDPdu, vertexDPdv, vec3(0.0f), 1.0f);
    vec4 counts = texelFetch(poseMap, 0);
    for (int target = 0; target < int(counts.y); ++target) {
        float weight = texelFetch(poseMap, 1 + 4 * int(counts.x) + target).x;
        if (weight == 0.0f)
            continue;
        int from = 4 * (target * int(counts.z) + gl_VertexID);
        vec4 a = texelFetch(morphMap, from);
        vec4 b = texelFetch(morphMap, from + 1);
        vec4 c = texelFetch(morphMap, from + 2);
        vec4 d = texelFetch(morphMap, from + 3);
        at.position += weight * a.xyz;
        at.normal += weight * vec3(a.w, b.xy);
        at.alongU += weight * vec3(b.zw, c.x);
        at.alongV += weight * c.yzw;
        at.fall += weight * d.xyz;
    }
    mat4 joints = jointMatrix(vertexJoints.x) * vertexWeights.x + jointMatrix(vertexJoints.y) * vertexWeights.y
        + jointMatrix(vertexJoints.z) * vertexWeights.z + jointMatrix(vertexJoints.w) * vertexWeights.w;
    mat3 linear = mat3(joints);
    mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    float determinant = dot(linear[0], cofactors[0]);
    vec3 turned = cofactors * normalize(at.normal) * (determinant < 0.0f ? -1.0f : 1.0f);
    float size = length(turned);
    at.position = (joints * vec4(at.position, 1.0f)).xyz;
    at.normal = size > 0.0f ? turned / size : at.normal;
    vec3 push = cofactors * at.push * (determinant < 0.0f ? -1.0f : 1.0f);
    at.push = dot(push, push) > 0.0f ? normalize(push) * length(at.push) : at.push;
    at.alongU = linear * at.alongU;
    at.alongV = linear * at.alongV;
    at.fallScale = size > 0.0f ? abs(determinant) / size : 1.0f;
    return at;
}
