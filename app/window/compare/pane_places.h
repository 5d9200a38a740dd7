// Where the panes lie in the viewport, and what of them is seen there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/compare/flip_map.h"
#include "app/window/compare/in_place.h"
#include "app/window/compare/pixel_zoom.h"
#include "app/window/viewport/pane_pictures.h"

namespace relievo {

// Of a viewport, which owns it. Positions are of the window, areas pixels of the screen.
class PanePlaces : public QObject {
    Q_OBJECT
public:
    PanePlaces(Document& document, std::function<std::size_t()> activePane, QWidget* viewport);
    InPlace& inPlace() const { return *m_inPlace; }
    PixelZoom& zoom() const { return *m_zoom; }
    FlipMap& flip() const { return *m_flip; }

    std::vector<PaneArea> areas() const; // empty for panes that are not shown
    std::vector<PaneArea> captionAreas() const; // where there is room for what is said of each
    std::size_t under(QPointF position) const; // the active pane where none lies
    // The point of the pane's picture that is seen at a position, a share from its upper left corner; and back.
    glm::vec2 toPicture(std::size_t pane, QPointF position) const;
    QPointF fromPicture(std::size_t pane, glm::vec2 share) const;
    Arrangement arrangement() const;
    // Computes what only some ways of comparing need, of pictures in full resolution; their context is current.
    void compare(PanePictures& pictures);

Q_SIGNALS:
    void arranged(); // other panes are shown, or elsewhere
    void composed(); // the same pictures, put together otherwise

private:
    int pixels(int size) const;
    QWidget* m_viewport;
    std::function<std::size_t()> m_activePane;
    InPlace* m_inPlace;
    PixelZoom* m_zoom;
    FlipMap* m_flip;
};

} // namespace relievo
