// The pixels under the pointer in all pictures at once, enlarged, with their values.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/background.h"
#include "app/window/inspector/inspection_job.h"
#include "core/image/image.h"
#include <QPointF>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace relievo {

class Assets;
class Document;
class Viewport;

// What is seen of one pane: a square of pixels, the middle one marked, and lines of text. A child of the viewport that takes no mouse.
class LoupeGlass : public QWidget {
    Q_OBJECT
public:
    explicit LoupeGlass(QWidget* viewport);
    void show(const Image& pixels, const QStringList& lines);
    QStringList lines() const { return m_lines; }
    QColor color() const; // of the middle pixel
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    Image m_pixels;
    QStringList m_lines;
};

class Loupe : public QObject {
    Q_OBJECT
public:
    Loupe(Document& document, Assets& assets, Viewport& viewport);
    void setOn(bool on);
    bool busy() const { return m_background.busy() || m_rest.isActive(); }

protected:
    bool eventFilter(QObject* viewport, QEvent* event) override;

private:
    void look(); // at the pixels
    void search(); // for depth, uv, fetches and error, off the interface's thread
    void place(std::size_t pane, LoupeGlass& glass);
    LoupeGlass& glass(std::size_t pane);
    QStringList linesOf(std::size_t pane, const LoupeGlass& glass) const;
    Document& m_document;
    Assets& m_assets;
    Viewport& m_viewport;
    Background m_background;
    QTimer m_rest;
    std::vector<LoupeGlass*> m_glasses; // of the panes
    std::optional<QPointF> m_at; // where the pointer is, in the viewport
    std::shared_ptr<const Inspected> m_found; // at m_foundAt
    std::optional<PickedPoint> m_foundAt;
    bool m_isOn = false;
};

} // namespace relievo
