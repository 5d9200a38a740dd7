// The exact answer on a mesh: the displaced surface itself, as micro-triangles traced by Embree.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/mesh/mesh.h"
#include "core/state/camera_view.h"
#include "core/state/parameters.h"
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace relievo {

// Every point of the mesh, pushed out for the midlevel, then moved in along the interpolated normal by the relief's depth there (none on
// plain parts); that is not made unit again, so that a constant height is the mesh itself, moved (height field bilinear: ARCHITECTURE.md,
// "Space, sign and unit"). Its triangles are cut into micro-triangles of half a texel; what opens between them at UV seams is closed by
// walls.
class DisplacedMesh {
public:
    struct Detail {
        float finest = 0.f; // m: no micro-triangle needs to be smaller than this
        std::size_t maxTriangles = 4'000'000; // about 100 bytes each; coarser when it takes more; walls come on top
        float coarser = 1.f; // how much longer the sides of the micro-triangles are made than half a texel or `finest`
    };
    // Errors: cancelled; Embree cannot start or has no memory.
    static Expected<DisplacedMesh> build(
        const Mesh& mesh, const HeightField& field, const Parameters& parameters, const Detail& detail, const Progress& progress = {});
    // finest: half of what a pixel of a picture `height` pixels high sees at the mesh's near side.
    static Detail detailFor(const Mesh& mesh, const CameraView& camera, float fovDegrees, int height);

    struct Hit {
        float distance = std::numeric_limits<float>::infinity(); // m along the unit direction; infinity when nothing is hit
        bool back = false; // of an open mesh, or of what is turned
        bool turned = false; // its triangle is (turningDepth): the relief is deeper than the mesh bends
    };
    // The first hit. The backs of a closed mesh are not hit unless they are turned: where its sheets part at a hard edge, a ray that only
    // meets their backs goes out again.
    Hit hit(glm::vec3 origin, glm::vec3 direction) const;
    std::size_t triangles() const;
    std::size_t bytes() const; // of Embree's scene and its buffers
    float coarseness() const; // how much longer their sides are than wanted; 1: as fine as wanted

private:
    struct Impl;
    std::shared_ptr<const Impl> m;
};

// What a picture of the camera sees of it.
struct PixelDistances {
    int width = 0, height = 0;
    std::size_t triangles = 0; // micro-triangles of the surface
    // From the eye, row 0 at the top; infinity where nothing is, NaN where pictures have no such surface: where the back of an open mesh is
    // seen, as relief goes in from the side that is seen, and where the relief has turned the surface over.
    std::vector<float> metres;
    // By how much each may be off because the micro-triangles are not finer, m; infinity where that decides whether there is a surface.
    // Empty: not known.
    std::vector<float> uncertain;

    bool isUncertain(int x, int y) const // whether there is a surface at all
    {
        return !uncertain.empty() && std::isinf(uncertain[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
    }
    float at(int x, int y) const { return metres[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};
Expected<PixelDistances> pixelDistances(
    const DisplacedMesh& surface, const CameraView& camera, int width, int height, const Progress& progress = {});

} // namespace relievo
