// What the window copies and pastes: the picture, and the camera as text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace relievo {

class Document;
class Messages;
class Viewport;

// What cannot be done stands in the messages.
void copyPicture(Viewport& viewport, Messages& messages); // nothing, when a pane cannot be drawn now
void copyCamera(const Document& document);
void pasteCamera(Document& document, Messages& messages);

} // namespace relievo
