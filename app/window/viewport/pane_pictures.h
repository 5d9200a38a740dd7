// The pictures of the panes in the viewport's OpenGL context: drawn, averaged while the hand rests, and shown.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_layout.h"
#include "app/window/viewport/smoother.h"
#include "core/image/image.h"
#include "render/compose.h"
#include "render/renderer.h"
#include <QImage>
#include <list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace relievo {

class MeshReference;
struct ViewRow;

// What the panes show. Refers to values of others.
struct ShownScene {
    State state;
    const Resources& resources;
    const MeshReference& reference;
    double pixelRatio; // pixels of the screen a pixel of the window
};

// How they are put on the screen.
struct Arrangement {
    std::vector<PaneArea> areas; // of the panes
    Composition composition; // its zoom holds for every pane; the rest for the pair, when there is one
    std::optional<std::pair<std::size_t, std::size_t>> pair; // panes that share one place
    const Image* first = nullptr; // is shown instead of the pair's first picture; RGBA U8, row 0 at the top
};

// Panes whose area is empty are not drawn. All calls need the context current in which it was made.
class PanePictures {
public:
    // A new picture of each pane at a share of its full resolution along each side; averaging begins anew. Says what could not be drawn.
    std::vector<Error> draw(const ShownScene& scene, const std::vector<PaneArea>& areas, double scale);
    // A slice more of the picture of each pane in full resolution, to take the place of a coarser one; about `ms` long. Whether it was the
    // last one of the last pane.
    bool fillSlice(const ShownScene& scene, const std::vector<PaneArea>& areas, double ms);
    // The same of the next picture, shifted below a pixel, for the mean of each pane; not where it is compared with an exact answer, which
    // is of the unshifted picture.
    bool addSlice(const ShownScene& scene, const std::vector<PaneArea>& areas, double ms);
    int samples() const; // averaged in what is shown, of the pane that has most; 0: as the pixels fall

    // Puts what was drawn into a framebuffer `height` pixels high.
    void show(unsigned framebuffer, const Arrangement& arrangement, int height);
    // A rectangle of the pane's picture as it is shown, pixels of it from its upper left corner: RGBA U8, row 0 at the top. Outside of the
    // picture it is transparent.
    Image pixels(std::size_t pane, const PaneArea& of);
    Image pixels(std::size_t pane); // the whole picture
    // The pixel at a share from the upper left corner, and so many around it.
    Image around(std::size_t pane, glm::vec2 share, int radius);

    // Counts the fetches of a pane, times it, and measures what a heat view shows; nothing for one that is not drawn.
    std::optional<Measurement> measure(const ShownScene& scene, std::size_t pane, const PaneArea& area);
    // Where the pane's search is most wrong, a share of the picture from its upper left corner; nothing where nothing is.
    std::optional<glm::vec2> worst(const ShownScene& scene, std::size_t pane, const PaneArea& area);
    // All panes in full resolution, `samples` pictures averaged in each; null when one of them cannot be drawn.
    QImage sheet(const ShownScene& scene, const std::vector<PaneArea>& areas, int samples);

    bool shadersChanged() const { return m_renderer.shadersChanged(); }

private:
    struct Picture {
        std::unique_ptr<Framebuffer> drawn = std::make_unique<Framebuffer>();
        std::unique_ptr<Framebuffer> sampled = std::make_unique<Framebuffer>(); // drawn slice by slice
        Smoother mean;
        double ms = 0; // that the full picture took; 0: not timed
    };
    struct Slices {
        std::size_t pane = 0; // that is being drawn
        int row = 0; // up to which it is
        double rowsPerMs = 1.; // as the last slice took
    };
    Picture& picture(std::size_t pane);
    void compose(unsigned framebuffer, const Arrangement& arrangement, int height);
    Expected<void> draw(const ShownScene& scene, std::size_t pane, const PaneArea& area, double scale);
    bool drawSlice(const ShownScene& scene, const PaneArea& area, Picture& own, int rows, bool shifted);
    // The next slice of the pane at hand, where `wanted`. Whether that pane's picture is whole, and whether it was drawn.
    struct Slice {
        bool isWhole, isDrawn;
    };
    Slice nextSlice(const ShownScene& scene, const PaneArea& area, double ms, bool wanted, bool shifted);
    bool nextPane(const std::vector<PaneArea>& areas); // whether it was the last
    std::optional<ViewNumbers> numbersOf(const ShownScene& scene, std::size_t pane, const PaneArea& area, const ViewRow& view);
    Renderer m_renderer;
    Composer m_composer;
    Slices m_slices;
    std::list<Picture> m_pictures; // of the panes in order; these do not move in memory
};

} // namespace relievo
