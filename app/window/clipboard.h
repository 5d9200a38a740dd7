// What the window copies and pastes: the picture, and the camera as text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace relievo {

class Document;
class Messages;
class Viewport;

// What cannot be done stands in the messages.
void copyPicture(Viewport& viewport, Messages& messages); // nothing, when a pane cannot be drawn now
void copyCamera(const Document& document, std::size_t pane);
void pasteCamera(Document& document, std::size_t pane, Messages& messages);

} // namespace relievo
