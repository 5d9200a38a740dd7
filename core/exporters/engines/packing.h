// Pictures packed of a material's maps, channel by channel, as a target wants them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/target_text.h"

namespace relievo {

// The heights as they are written: stretched from [low, low + span] to [0, 1], so that the depth of black to white is `span` of the
// material's.
struct WrittenHeights {
    std::optional<HeightField> field;
    float low = 0.f, span = 1.f;
    bool isFine = false; // came in more than 8 bits

    float midlevel(const Parameters& parameters) const
    {
        return (parameters.midlevel - low) / span;
    } // of the written heights; may leave [0, 1]
    // The parameters that draw the written heights as the material's own are drawn, as far as a midlevel in [0, 1] does.
    Parameters with(const Parameters& parameters) const;
    // One step of 8 bits in widths of a texel, where the heights came in finer ones; else 0. Terraces show where it is not small.
    float coarseness(const Parameters& parameters) const;
};
WrittenHeights writtenHeights(const ExportJob& job, const Parameters& parameters);

// Whether the technique that is exported searches a map of codes.
bool ownMapHoldsCodes(const ExportJob& job);

// Whether one of the channels comes from a map that the material has (normals: also where they can be made).
bool isPresent(const PackedTexture& texture, const ExportJob& job);

// The picture, at most job.size texels on its longest side; a channel without a map has the value that the map's row names. What is
// srgb keeps its encoding. Empty when cancelled.
Image packed(const PackedTexture& texture, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

// What is in the picture that `packed` makes: equal texts, equal pictures.
std::string contentOf(const PackedTexture& texture, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters);

} // namespace relievo
