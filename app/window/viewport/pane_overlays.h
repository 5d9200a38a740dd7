// What stands over the panes and where: captions, legends of heat maps, the hint.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/pane_layout.h"
#include "render/renderer.h"
#include <functional>
#include <optional>
#include <vector>

namespace relievo {

class MeshReference;

// Children of the viewport, which owns them.
class PaneOverlays {
public:
    // A caption that is pressed calls `pressed` and then offers what it names; `ownValuesWanted`: the panel is to reach that pane only.
    struct Wishes {
        std::function<void(std::size_t pane)> pressed, ownValuesWanted;
    };
    PaneOverlays(QWidget* viewport, Document& document, Wishes wishes);

    // What they say. measured: of each pane, where it is known; reference: how far the displaced mesh is.
    void update(const std::vector<std::optional<Measurement>>& measured, const MeshReference& reference, std::size_t activePane);
    // Where they stand; areas: of the panes, in pixels of the screen.
    void place(const std::vector<PaneArea>& areas, double pixelRatio);
    void say(const QString& hint); // "" for nothing

private:
    void chooseTechnique(std::size_t pane);
    void chooseView(std::size_t pane);
    void chooseMore(std::size_t pane);
    void placeHint();
    void fitRange(std::size_t pane, double most);
    void makeFor(std::size_t panes);
    QWidget* m_viewport;
    Document& m_document;
    Wishes m_wishes;
    std::vector<PaneCaption*> m_captions;
    std::vector<HeatLegend*> m_legends;
    Hint* m_hint;
};

} // namespace relievo
