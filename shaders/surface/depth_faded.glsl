// The relief grows shallow where the surface is seen edge-on (the thesis on derivative-based relief mapping): no smear at the outline, and
// no relief there either.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float depthSeen(float cosView)
{
    return reliefDepth * smoothstep(0.0f, edgeFade, abs(cosView));
}
