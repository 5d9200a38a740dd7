// What the main window copies and pastes: the picture, and the camera as text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"
#include "app/window/viewport/viewport.h"
#include <QApplication>
#include <QClipboard>

namespace relievo {

void MainWindow::copyPicture()
{
    const QImage picture = m_viewport->picture();
    if (picture.isNull())
        return m_messages.set(
            "copy", Error{"one of the pictures cannot be drawn now", tr("Copy picture").toStdString(), "Nothing was copied"});
    m_messages.clear("copy");
    QApplication::clipboard()->setImage(picture);
}

void MainWindow::copyCamera()
{
    QApplication::clipboard()->setText(QString::fromStdString(toText(m_document.state().camera)));
}

void MainWindow::pasteCamera()
{
    const std::string text = QApplication::clipboard()->text().trimmed().toStdString();
    Camera camera = m_document.state().camera;
    if (const auto read = setCamera(camera, text); !read)
        return m_messages.set("camera", read.error());
    m_messages.clear("camera");
    m_document.edit({}, [&](State& state) { state.camera = camera; });
}

} // namespace relievo
