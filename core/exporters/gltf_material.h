// A material as glTF has it, its relief in the extension RELIEVO_materials_relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include "core/exporters/glb_file.h"

namespace relievo {

// Material 0, with its textures; parameters: as they take effect. Adds to `warnings` what its relief will lack.
Expected<void> addMaterial(GlbFile& file, const ExportJob& job, const Parameters& parameters, Warnings& warnings);

// For the parts of a mesh that do not bear the material.
void addPlainMaterial(GlbFile& file, const Parameters& parameters);

} // namespace relievo
