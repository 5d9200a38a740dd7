// Menus of the techniques and of the views, walked from their tables.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <QKeySequence>
#include <QVector>
#include <functional>
#include <string>

class QMenu;

namespace relievo {

// Those that the GPU can draw, in the table's order: of meshes, or of relief objects.
QVector<const TechniqueRow*> drawnTechniques(bool ofObjects = false);

// What brings each of them in the window; empty after the ninth technique and the twelfth view.
QKeySequence techniqueKeys(int index); // into drawnTechniques()
QKeySequence viewKeys(std::size_t index); // into kViews

// Under a heading for each kind of search; `current` is ticked, "" for none. Those of relief objects where it is one.
void fillTechniques(QMenu& menu, const std::string& current, const std::function<void(const TechniqueRow&)>& chosen);
void fillViews(QMenu& menu, const std::string& current, const std::function<void(const ViewRow&)>& chosen);

} // namespace relievo
