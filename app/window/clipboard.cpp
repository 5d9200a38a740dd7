// Copying and pasting.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/clipboard.h"
#include "app/window/document/document.h"
#include "app/window/document/messages.h"
#include "app/window/viewport/viewport.h"
#include <QApplication>
#include <QClipboard>

namespace relievo {

void copyPicture(Viewport& viewport, Messages& messages)
{
    const QImage picture = viewport.picture();
    if (picture.isNull())
        return messages.set(
            "copy", Error{"one of the pictures cannot be drawn now", QObject::tr("Copy picture").toStdString(), "Nothing was copied"});
    messages.clear("copy");
    QApplication::clipboard()->setImage(picture);
}

void copyCamera(const Document& document, std::size_t pane)
{
    QApplication::clipboard()->setText(QString::fromStdString(toText(cameraOf(document.state(), pane))));
}

void pasteCamera(Document& document, std::size_t pane, Messages& messages)
{
    const std::string text = QApplication::clipboard()->text().trimmed().toStdString();
    Camera camera = cameraOf(document.state(), pane);
    if (const auto read = setCamera(camera, text); !read)
        return messages.set("camera", read.error());
    messages.clear("camera");
    document.edit({}, [&](State& state) { setCameraOf(state, pane, camera); });
}

} // namespace relievo
