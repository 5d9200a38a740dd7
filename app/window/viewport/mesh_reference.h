// The displaced mesh as the panes see it, made in the background for the error view at rest.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/trace/displaced_mesh.h"
#include <QObject>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    // The message line says so meanwhile.
    void want(int width, int height);
    bool busy() const { return m_background.busy(); }

Q_SIGNALS:
    void made();

private:
    // All that the answer depends on: whoever changes colours, techniques or ranges keeps it.
    struct Question {
        Camera camera;
        std::string part;
        std::vector<Parameters> panes; // at their defaults, but for those that move the surface
        std::shared_ptr<const void> heights, mesh;
        bool operator==(const Question&) const = default;
    };
    Question question() const;
    void follow();
    void tell();
    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    Background m_background;
    std::array<std::shared_ptr<const SeenDistances>, 2> m_seen; // of the panes; kept while another view is shown
    QList<Message> m_told; // with it
    std::optional<Question> m_question; // that they answer
    int m_width = 0, m_height = 0; // that they were wanted for; 0 when nothing is made or being made
};

} // namespace relievo
