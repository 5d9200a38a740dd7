// What joins the ray inspector and the picture: a click, and a ring where it looks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/inspector/inspection_job.h"
#include <QWidget>
#include <optional>

namespace relievo {

class Document;
class RayInspector;
class Viewport;

// A child of the viewport that takes no mouse.
class PickMarker : public QWidget {
    Q_OBJECT
public:
    explicit PickMarker(Viewport* viewport);
    void show(const std::optional<PickedPoint>& point); // nothing: hidden

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; // the viewport changes its size
    void paintEvent(QPaintEvent*) override;

private:
    void place();
    const Viewport& m_viewport;
    std::optional<PickedPoint> m_point;
};

// While the inspector is seen, a click in the viewport is what it looks at.
void connectPicking(RayInspector& inspector, Viewport& viewport, Document& document);

} // namespace relievo
