// Dividing the viewport.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/pane_layout.h"
#include <algorithm>

namespace relievo {

namespace {
constexpr int kGap = 2; // pixels between two panes
constexpr int kLongestRow = 3; // panes in a single row

// Part i of n along a length: where it begins, and how long it is.
struct Part {
    int from, size;
};
Part part(int i, int n, int length)
{
    const int size = std::max((length - (n - 1) * kGap) / n, 1);
    return {n == 1 ? 0 : i * (length - size) / (n - 1), size};
}
} // namespace

std::vector<PaneArea> paneAreas(int count, int width, int height)
{
    const int rows = count <= kLongestRow ? 1 : 2;
    const int columns = (count + rows - 1) / rows;
    std::vector<PaneArea> areas;
    for (int i = 0; i < count; ++i) {
        const int row = i / columns, inRow = std::min(columns, count - row * columns);
        const Part across = part(i % columns, inRow, width), down = part(row, rows, height);
        areas.push_back({across.from, down.from, across.size, down.size});
    }
    return areas;
}

std::optional<std::size_t> paneAt(const std::vector<PaneArea>& areas, QPointF point)
{
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const PaneArea& area = areas[i];
        if (point.x() >= area.x && point.x() < area.x + area.width && point.y() >= area.y && point.y() < area.y + area.height)
            return i;
    }
    return {};
}

} // namespace relievo
