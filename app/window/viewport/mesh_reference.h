// The displaced mesh as the panes see it, traced in the background for views of errors at rest.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "app/window/viewport/pane_layout.h"
#include "core/scene/exact_distances.h"
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace relievo {

class MeshReference : public QObject {
    Q_OBJECT
public:
    MeshReference(Document& document, Assets& assets, Messages& messages, QObject* parent = nullptr);

    // Whether the pane's view is compared with the displaced mesh, pixel by pixel; any: of any pane.
    bool isShown(std::size_t pane) const;
    bool anyShown() const;
    // What was traced for the pane last, or null. Whether it still answers is for DrawRequest::compareWith to say.
    std::shared_ptr<const ExactDistances> exactOf(std::size_t pane) const;
    // Traces what the panes lack; until then their views measure the search alone, and the message line says so.
    void want(const std::vector<PaneArea>& areas);
    bool busy() const { return m_background.busy(); }
    int percent() const { return m_percent; } // of what is being traced

Q_SIGNALS:
    void made();
    void progressed();

private:
    using Questions = std::vector<std::optional<ExactQuestion>>; // of the panes; nothing where the view is another
    Questions questions(const std::vector<PaneArea>& areas) const;
    bool answers(std::size_t pane) const; // what was traced for it, still
    void follow();
    void tell();
    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    Background m_background;
    int m_percent = 0;
    std::vector<std::shared_ptr<const ExactDistances>> m_exact; // of the panes; kept while another view is shown
    QList<Message> m_told; // with it
    Questions m_asked; // answered, being answered, or failed
    std::vector<PaneArea> m_areas; // that it was asked for
};

} // namespace relievo
