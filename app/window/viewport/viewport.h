// The picture: one pane or two side by side, drawn coarse while the hand moves and in full when it rests.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "app/window/viewport/frame_pacer.h"
#include "app/window/viewport/mesh_reference.h"
#include "app/window/viewport/navigation.h"
#include "app/window/viewport/smoother.h"
#include "render/renderer.h"
#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>
#include <QSet>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

namespace relievo {

class HeatLegend;
class Hint;
class PaneCaption;

class Viewport : public QOpenGLWidget {
    Q_OBJECT
public:
    Viewport(Document& document, Assets& assets, Messages& messages, QWidget* parent = nullptr);
    ~Viewport() override;

    int activePane() const { return m_activePane; } // the one that the technique bar speaks of
    void setActivePane(int pane);
    QImage picture(); // what is shown, in full resolution, without captions; null when a pane cannot be drawn
    // Pictures averaged in what is shown: 0 while the edges are as the pixels fall, kSmoothSamples in the end.
    int smoothSamples() const { return m_pictures ? m_pictures->smooth[0].count() : 0; }
    static constexpr int kSmoothSamples = 8;
    bool isFull() const { return !m_stale && m_shownScale >= 1.; } // the picture shown has the full resolution
    // Nothing more to come.
    bool isSettled() const { return isFull() && !m_measuring.isActive() && !m_smoothing.isActive() && !m_reference->busy(); }
    double shownScale() const { return m_shownScale; }

Q_SIGNALS:
    void activePaneChanged(int pane);
    void painted(bool full);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    struct PaneArea {
        int x = 0, width = 0, height = 0; // pixels of the screen
    };
    int paneCount() const { return int(m_document.state().panes.size()); }
    PaneArea area(int pane) const;
    CameraView sight() const;
    void documentChanged(Changes what);
    void refresh(bool moving); // a new picture is wanted
    void drawPanes(double scale);
    void drawn(const QList<Message>& troubles);
    Expected<void> drawPane(int pane, double scale, glm::vec2 shift);
    void smooth();
    void showPanes();
    void measure();
    void placeOverlays();
    void updateOverlays();
    void moveCamera(const Camera& camera);
    void endDrag();
    void fly();
    void chooseTechnique(int pane);

    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    std::unique_ptr<Renderer> m_renderer;
    struct Pictures { // of the panes; goes with the context
        std::array<Framebuffer, 2> drawn;
        std::array<Smoother, 2> smooth;
    };
    std::unique_ptr<Pictures> m_pictures;
    MeshReference* m_reference;
    FramePacer m_pacer;
    QTimer m_rest, m_measuring, m_smoothing, m_flying, m_shaderWatch;
    bool m_stale = true, m_moving = false;
    double m_shownScale = 0; // of the full resolution along each side
    std::array<std::optional<Measurement>, 2> m_measured;

    int m_activePane = 0;
    std::optional<Gesture> m_drag;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    QPointF m_last;
    QSet<int> m_keys;
    QElapsedTimer m_flyClock;

    std::array<PaneCaption*, 2> m_captions{};
    std::array<HeatLegend*, 2> m_legends; // of the panes; the first one alone when they show one range
    Hint* m_hint;
};

} // namespace relievo
