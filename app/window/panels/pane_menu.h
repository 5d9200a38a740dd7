// What can be done with one of several pictures: a menu.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QKeySequence>
#include <cstddef>
#include <functional>

class QMenu;

namespace relievo {

class Document;
struct TechniqueRow;

// Of that pane, as the document is now; it may have changed when an item is chosen. ownValuesWanted: what is changed from now on is to
// reach this pane only.
void fillPaneMenu(QMenu& menu, Document& document, std::size_t pane, const std::function<void()>& ownValuesWanted);

// One undo step each; nothing when there is no such pane.
void chooseTechnique(Document& document, std::size_t pane, const TechniqueRow& technique);
void swapPanes(Document& document, std::size_t one, std::size_t other);

// Numbers of pictures that fill a window well.
inline constexpr std::size_t kPaneCounts[] = {1, 2, 3, 4, 6};
inline QKeySequence paneCountKeys(std::size_t count)
{
    return QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + int(count)));
}
void fillPaneCounts(QMenu& menu, std::size_t current, const std::function<void(std::size_t)>& chosen);

} // namespace relievo
