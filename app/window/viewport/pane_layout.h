// Where the panes lie in the viewport: side by side, in two rows from four on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QPointF>
#include <cstddef>
#include <optional>
#include <vector>

namespace relievo {

// Pixels of the screen, y down from the top.
struct PaneArea {
    int x = 0, y = 0, width = 0, height = 0;
    bool isEmpty() const { return width == 0; } // its pane is not shown
    float aspect() const { return float(width) / float(height > 0 ? height : 1); }
};

// One for each pane, of a viewport of that size; what remains between them is a gap. At least one pixel each.
std::vector<PaneArea> paneAreas(int count, int width, int height);

// Which of them holds the point; nothing in a gap.
std::optional<std::size_t> paneAt(const std::vector<PaneArea>& areas, QPointF point);

} // namespace relievo
