// Fragment stage of the floor under the mesh: how much of the light on a white floor the mesh keeps away, as black with that opacity. So it
// fades into whatever is behind it, and is a shadow alone where nothing is. groundPlace, 0: the middle of the mesh, and the height of the
// floor. 1: half the mesh's size, and half the floor's.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 position;
layout(location = 0) out vec4 fragment;
const int kDirectional = 1; // of the first light's kind: only such a one has a shadow map

// Share of the light's rays that pass the mesh: samples of the shadow map on a spiral as wide as the light's penumbra may be there.
float lightPassingMesh()
{
    vec4 clip = shadowFromWorld * vec4(position, 1.0f);
    vec3 p = vec3(clip.x, clip.y, min(clip.z, 1.0f)) * 0.5f + 0.5f;
    float texel = 1.0f / float(textureSize(shadowMap, 0).x);
    float wide = max(2.5f * texel, 0.01f + 0.004f * lightSize);
    float turn = (fract(52.9829189f * fract(dot(gl_FragCoord.xy, vec2(0.06711056f, 0.00583715f)))) + sampleTurn) * 6.2831853f;
    float lit = 0.0f;
    for (int i = 0; i < 24; ++i) {
        float radius = wide * sqrt((float(i) + 0.5f) / 24.0f);
        float angle = float(i) * 2.3999632f + turn;
        lit += texture(shadowMap, p + vec3(radius * cos(angle), radius * sin(angle), 0.0f)) / 24.0f;
    }
    return 1.0f - shadowStrength * (1.0f - lit);
}

// Share of the light from all around that reaches the floor past an ellipsoid in the mesh's bounds: the exact one of a sphere, the room
// stretched to make it one, and less for flat meshes.
float surroundingsPassingMesh()
{
    vec3 extent = vec3(groundPlace[1].x, groundPlace[1].y, groundPlace[1].z);
    vec3 away = (position - vec3(groundPlace[0].x, groundPlace[0].y, groundPlace[0].z)) / extent;
    float square = max(dot(away, away), 1.0f);
    float hidden = min(-away.y, 1.0f) / (square * sqrt(square));
    return 1.0f - clamp(hidden, 0.0f, 1.0f) * clamp(2.0f * extent.y / (extent.x + extent.z), 0.0f, 1.0f);
}

void main()
{
    vec3 around = irradiance(vec3(0.0f, 1.0f, 0.0f)) * environmentIntensity;
    float lightReceived = lightKind == kDirectional ? lightIntensity * max(lightDirection.y, 0.0f) : 0.0f;
    float surroundings = dot(around, vec3(0.2126f, 0.7152f, 0.0722f));
    float whole = lightReceived * dot(lightColor, vec3(0.2126f, 0.7152f, 0.0722f)) + surroundings;
    float kept = (surroundings * surroundingsPassingMesh() + (whole - surroundings) * lightPassingMesh()) / max(whole, 1e-6f);
    vec2 apart = vec2(position.x - groundPlace[0].x, position.z - groundPlace[0].z) / groundPlace[1].w;
    float fading = 1.0f - smoothstep(0.35f, 1.0f, length(apart));
    fragment = vec4(0.0f, 0.0f, 0.0f, fading * (1.0f - shownShare(kept)));
}
