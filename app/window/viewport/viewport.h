// The picture: the panes, drawn coarse while the hand moves and in full when it rests.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/compare/pane_places.h"
#include "app/window/document/assets.h"
#include "app/window/viewport/at_rest.h"
#include "app/window/viewport/frame_pacer.h"
#include "app/window/viewport/mesh_reference.h"
#include "app/window/viewport/navigator.h"
#include "app/window/viewport/pane_overlays.h"
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace relievo {

class Viewport : public QOpenGLWidget {
    Q_OBJECT
public:
    Viewport(Document& document, Assets& assets, Messages& messages, QWidget* parent = nullptr);
    ~Viewport() override;

    int activePane() const { return m_activePane; } // the one that the technique bar speaks of
    void setActivePane(int pane);
    QImage picture(); // what is shown, in full resolution, without captions; null when a pane cannot be drawn
    // Pictures averaged in what is shown: 0 while the edges are as the pixels fall.
    int smoothSamples() const { return m_pictures ? m_pictures->samples() : 0; }
    const SamplesAtRest& samplesAtRest() const { return m_atRest->samples(); }
    void wantSamples(int samples) { m_atRest->want(samples), refresh(false); }
    bool isFull() const { return !m_stale && m_shownScale >= 1.; } // the picture shown has the full resolution
    // Nothing more to come.
    bool isSettled() const { return isFull() && !m_atRest->isActive() && !m_reference->busy(); }
    double shownScale() const { return m_shownScale; }
    const MeshReference& reference() const { return *m_reference; }
    PanePlaces& places() const { return *m_places; }
    void say(const QString& text) { m_overlays.say(text); } // a hint; "" when there is none any more
    void keepMoving() { refresh(true); } // more follows at once
    // Where the pane is most wrong against the exact search; nothing where it is not.
    std::optional<glm::vec2> worstPoint(std::size_t pane);
    // So many pixels of the pane's picture around one, as they are shown; see PanePictures::around.
    Image pixelsAround(std::size_t pane, glm::vec2 share, int radius);

Q_SIGNALS:
    void activePaneChanged(int pane);
    void painted(bool full);
    void clicked(std::size_t pane, QPointF position);
    void ownValuesWanted(std::size_t pane);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

private:
    std::size_t paneCount() const { return m_document.state().panes.size(); }
    std::vector<PaneArea> areas() const { return m_places->areas(); }
    ShownScene scene() const { return {m_assets.drawnState(), m_assets.drawnResources(), *m_reference, devicePixelRatioF()}; }
    Navigator::PaneView view(std::size_t pane) const;
    void documentChanged(Changes what);
    void refresh(bool moving); // a new picture is wanted
    void drawPanes(double scale);
    void drawn(const QList<Message>& troubles);
    void updateOverlays();

    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    std::unique_ptr<PanePictures> m_pictures; // goes with the context
    MeshReference* m_reference;
    Navigator* m_navigator;
    PanePlaces* m_places;
    AtRest* m_atRest;
    PaneOverlays m_overlays;
    FramePacer m_pacer;
    QTimer m_rest, m_shaderWatch;
    bool m_stale = true, m_moving = false;
    double m_shownScale = 0; // of the full resolution along each side
    int m_activePane = 0;
};

} // namespace relievo
