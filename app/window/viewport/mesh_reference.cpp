// Tracing the displaced mesh off the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/mesh_reference.h"
#include "core/state/views.h"
#include <utility>

namespace relievo {

MeshReference::MeshReference(Document& document, Assets& assets, Messages& messages, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
{
    connect(&document, &Document::changed, this, &MeshReference::follow);
    connect(&assets, &Assets::resourcesChanged, this, &MeshReference::follow);
    connect(&m_background, &Background::progressed, this, [this](float share) {
        if (std::exchange(m_percent, int(share * 100.f)) != int(share * 100.f))
            Q_EMIT progressed();
    });
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        m_told = {{true, tr("The displaced mesh could not be made: %1.").arg(what)}};
        tell();
    });
}

bool MeshReference::isShown(std::size_t pane) const
{
    const State& state = m_document.state();
    const ViewRow* view = pane < state.panes.size() ? findView(state.panes[pane].view) : nullptr;
    return view && !view->fileOnMesh.empty() && m_assets.ready() && hasMeshReference(state, m_assets.resources());
}

bool MeshReference::anyShown() const
{
    for (std::size_t pane = 0; pane < m_document.state().panes.size(); ++pane)
        if (isShown(pane))
            return true;
    return false;
}

std::shared_ptr<const ExactDistances> MeshReference::exactOf(std::size_t pane) const
{
    return pane < m_exact.size() && isShown(pane) ? m_exact[pane] : nullptr;
}

bool MeshReference::answers(std::size_t pane) const
{
    const ExactQuestion& question = m_exact[pane]->question;
    return pane < m_document.state().panes.size()
        && question == exactQuestion(m_document.state(), pane, m_assets.resources(), question.width, question.height);
}

MeshReference::Questions MeshReference::questions(const std::vector<PaneArea>& areas) const
{
    Questions questions(m_document.state().panes.size());
    for (std::size_t pane = 0; pane < questions.size() && pane < areas.size(); ++pane)
        if (isShown(pane) && !areas[pane].isEmpty())
            questions[pane] = exactQuestion(m_document.state(), pane, m_assets.resources(), areas[pane].width, areas[pane].height);
    return questions;
}

void MeshReference::follow()
{
    const bool isAnother = anyShown() && m_asked != questions(m_areas);
    if (isAnother || (!anyShown() && m_background.busy())) {
        m_background.cancel();
        m_asked.clear(), m_areas.clear(), m_told.clear();
        for (std::size_t pane = 0; pane < m_exact.size(); ++pane) // another pane's answer stays
            if (m_exact[pane] && !answers(pane))
                m_exact[pane].reset();
    }
    tell();
}

void MeshReference::tell()
{
    m_messages.set("reference", anyShown() ? m_told : QList<Message>());
    if (anyShown() && (m_areas.empty() || m_background.busy()))
        m_messages.setNotice("tracing", tr("The error is against the flat relief until the displaced mesh has been traced."));
    else
        m_messages.clear("tracing");
}

void MeshReference::want(const std::vector<PaneArea>& areas)
{
    if (!anyShown() || questions(areas) == m_asked) // also when it could not be made
        return;
    m_areas = areas;
    m_asked = questions(areas);
    m_percent = 0;
    m_background.start([this, state = m_document.state(), resources = m_assets.resources(), asked = m_asked, kept = m_exact](
                           const Progress& progress) -> Background::Then {
        std::vector<std::shared_ptr<const ExactDistances>> exact(asked.size());
        QList<Message> told;
        for (std::size_t pane = 0; pane < asked.size(); ++pane) {
            if (pane < kept.size() && kept[pane] && asked[pane] == kept[pane]->question)
                exact[pane] = kept[pane];
            if (!asked[pane] || exact[pane])
                continue;
            Warnings coarse;
            const Progress share = progress.part(float(pane) / float(asked.size()), float(pane + 1) / float(asked.size()));
            auto distances = sureDistances(state, pane, resources, asked[pane]->width, asked[pane]->height, coarse, share);
            if (!distances)
                told.append({true, QString::fromStdString(message(distances.error()))});
            else
                exact[pane] = std::move(*distances);
            for (const Warning& warning : coarse)
                told.append({false, QString::fromStdString(warning.text)});
        }
        return [this, exact, told] {
            m_told = told, m_exact = exact;
            tell();
            Q_EMIT made();
        };
    });
    tell();
}

} // namespace relievo
