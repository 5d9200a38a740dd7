// Tracing the displaced mesh off the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/mesh_reference.h"
#include "render/mesh_errors.h"

namespace relievo {

MeshReference::MeshReference(Document& document, Assets& assets, Messages& messages, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
{
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & ~Changes(Change::Name))
            forget();
    });
    connect(&assets, &Assets::resourcesChanged, this, &MeshReference::forget);
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        m_messages.set("reference", {{true, tr("The displaced mesh could not be made: %1.").arg(what)}});
    });
}

bool MeshReference::isShown() const
{
    return m_document.state().view == "error" && m_assets.ready() && hasMeshReference(m_document.state(), m_assets.resources());
}

Resources MeshReference::resourcesOf(int pane) const
{
    Resources resources = m_assets.resources();
    resources.seen = m_seen[std::size_t(pane)];
    return resources;
}

void MeshReference::forget()
{
    m_background.cancel();
    m_seen = {};
    m_width = m_height = 0;
    m_messages.set("reference", QList<Message>());
}

void MeshReference::want(int width, int height)
{
    if (!isShown() || (width == m_width && height == m_height)) // also when it could not be made
        return;
    m_width = width, m_height = height;
    m_background.start(
        [this, state = m_document.state(), resources = m_assets.resources(), width, height](const Progress& progress) -> Background::Then {
            std::array<std::shared_ptr<const SeenDistances>, 2> seen;
            QList<Message> told;
            for (std::size_t pane = 0; pane < state.panes.size(); ++pane) {
                Warnings coarse;
                auto distances = exactDistances(state, pane, resources, width, height, coarse, progress);
                if (!distances)
                    told.append({true, QString::fromStdString(message(distances.error()))});
                else
                    seen[pane] = std::make_shared<const SeenDistances>(std::move(*distances));
                for (const Warning& warning : coarse)
                    told.append({false, QString::fromStdString(warning.text)});
            }
            return [this, seen, told] {
                m_messages.set("reference", told);
                m_seen = seen;
                Q_EMIT made();
            };
        });
}

} // namespace relievo
