// What a scene shows its material on: a mesh, or the box of a relief object.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/object/relief_object.h"

namespace relievo {

// State::mesh: as openMesh, or "object:SHAPE" (core/state/shapes.h) or NAME.object.json (resources/help/objects.md): then the mesh is the
// object's box, in its own place and size, and carries the object. Errors: of both.
Expected<Mesh> openSceneMesh(const std::string& nameOrFile, const Progress& progress = {});

// The box of an object, each side with its own corners, which counts as one part.
Expected<Mesh> boxMesh(const ReliefObject& object, const std::string& name);

} // namespace relievo
