// Small pictures of maps for the map panel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include <QImage>
#include <QString>

namespace relievo {

// The map scaled to fit size x size pixels, each the mean of at most 16 samples; null when the material has no such map.
QImage thumbnail(const Material& material, MapKind kind, int size);

// "1024 x 1024  16 bit"; "" when the material has no such map.
QString mapFacts(const Material& material, MapKind kind);

} // namespace relievo
