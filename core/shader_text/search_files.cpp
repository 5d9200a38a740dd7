// Choosing the files by the form of the technique's acceleration map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/search_files.h"
#include "core/maps/maps.h"

namespace relievo {

void accelerationFiles(Assembly& part, const TechniqueRow& technique, const Readers& readers)
{
    if (technique.accelerationMap.empty())
        return;
    const MapForm form = findBakedMap(technique.accelerationMap)->form;
    if (form == MapForm::Pyramid || form == MapForm::Codes)
        part.file(form == MapForm::Pyramid ? readers.nodes : readers.codes);
    else
        part.file("bounds/bounds_scale.glsl").file(form == MapForm::Volume ? readers.volume : readers.filtered);
}

void exactFiles(Assembly& part, const TechniqueRow& technique, const Readers& readers, std::string_view edges, std::string_view bend)
{
    part.file("heights/stored_exact.glsl");
    if (technique.needsHeights())
        part.file("heights/level_base.glsl")
            .file(edges)
            .file("heights/wrapped_texel.glsl")
            .file(readers.corners)
            .file("heights/heights_exact.glsl")
            .file(bend)
            .file("search/height_on.glsl");
    accelerationFiles(part, technique, readers);
    part.file(technique.file);
}

} // namespace relievo
