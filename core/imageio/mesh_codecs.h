// Triangles and numbers that glTF files hold compressed: Draco and meshoptimizer, decoded here because a bad file can end the process.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/imageio/channel.h"

namespace relievo::imageio {

// Each takes the compressed bytes that follow the request, and answers with Data as imageio_protocol.h says.
void answerMeshopt(Channel& channel, const MeshoptRequest& request);
void answerDraco(Channel& channel, const DracoRequest& request);

} // namespace relievo::imageio
