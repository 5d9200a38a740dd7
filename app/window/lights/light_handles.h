// Handles of the lights in the picture: a sun with its ray, a bulb, a cone. They stand there while Shift or L is held, and those of lights
// whose section of the panel is open; a drag moves the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "app/window/lights/light_places.h"
#include <QPointF>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

class QMouseEvent;

namespace relievo {

class Assets;
class Viewport;

struct LightHandle {
    std::size_t pane = 0, light = 0;
    QPointF at, middle; // in the viewport; of the light and of what it shines on
    LightPlace place = {};
};

// Lies over the viewport and takes no mouse itself; it hears what the viewport hears, before that, and takes presses on handles.
class LightHandles : public QWidget {
    Q_OBJECT
public:
    // isOpen: the section of that light in the panel.
    LightHandles(Document& document, Assets& assets, Viewport& viewport, std::function<bool(std::size_t light)> isOpen);
    std::vector<LightHandle> handles() const; // that are shown now
    void update(); // what is shown has changed

protected:
    void paintEvent(QPaintEvent*) override;
    bool eventFilter(QObject* viewport, QEvent* event) override;

private:
    struct Drag {
        LightHandle handle;
        QPointF grip; // from the hand to the middle of the handle
        QPointF last;
    };
    bool press(const QMouseEvent& event);
    void move(QPointF at);
    void edit(const std::function<void(Parameters& lit)>& change); // of the light that is dragged
    void letGo();
    void setHeld(bool held);
    CameraView camera(std::size_t pane) const;
    QString told() const; // of the light that is dragged: where it is, and what arrives

    Document& m_document;
    Assets& m_assets;
    Viewport& m_viewport;
    std::function<bool(std::size_t)> m_isOpen;
    std::optional<Drag> m_drag;
    bool m_isHeld = false; // Shift or L
};

} // namespace relievo
