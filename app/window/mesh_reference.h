// The displaced mesh as the panes see it, made in the background for the error view at rest.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/assets.h"
#include "core/trace/displaced_mesh.h"
#include <QObject>
#include <array>
#include <memory>

namespace relievo {

class MeshReference : public QObject {
    Q_OBJECT
public:
    MeshReference(Document& document, Assets& assets, Messages& messages, QObject* parent = nullptr);

    // Whether the view shown is compared with the displaced mesh, pixel by pixel.
    bool isShown() const;
    // The resources with what the pane sees, when that is made already.
    Resources resourcesOf(int pane) const;
    // Makes it for panes of that size, pixels, when it is not there; until then the view measures the search alone.
    void want(int width, int height);
    bool busy() const { return m_background.busy(); }

Q_SIGNALS:
    void made();

private:
    void forget();
    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    Background m_background;
    std::array<std::shared_ptr<const SeenDistances>, 2> m_seen; // of the panes, until something changes
    int m_width = 0, m_height = 0; // that they were wanted for
};

} // namespace relievo
