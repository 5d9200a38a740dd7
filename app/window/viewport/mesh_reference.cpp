// Tracing the displaced mesh off the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/mesh_reference.h"
#include "render/measure/mesh_errors.h"

namespace relievo {

MeshReference::MeshReference(Document& document, Assets& assets, Messages& messages, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
{
    connect(&document, &Document::changed, this, &MeshReference::follow);
    connect(&assets, &Assets::resourcesChanged, this, &MeshReference::follow);
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        m_told = {{true, tr("The displaced mesh could not be made: %1.").arg(what)}};
        tell();
    });
}

bool MeshReference::isShown() const
{
    return m_document.state().view == "error" && m_assets.ready() && hasMeshReference(m_document.state(), m_assets.resources());
}

Resources MeshReference::resourcesOf(int pane) const
{
    Resources resources = m_assets.resources();
    if (isShown())
        resources.seen = m_seen[std::size_t(pane)];
    return resources;
}

MeshReference::Question MeshReference::question() const
{
    const State& state = m_document.state();
    const Resources& resources = m_assets.resources();
    Question question{state.camera, state.part, {}, resources.material->height->identity(), resources.mesh};
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane) {
        const Parameters parameters = effectiveParameters(state, pane);
        Parameters& kept = question.panes.emplace_back();
        for (const ParameterRow& row : kParameters)
            if (row.shown == "animated" || (row.group == Group::Shape && row.key != "normalStrength"))
                set(kept, row, get(parameters, row));
    }
    return question;
}

void MeshReference::follow()
{
    const bool isAnother = isShown() && m_question != question();
    if (isAnother || (!isShown() && m_background.busy())) {
        m_background.cancel();
        m_seen = {}, m_told = {};
        m_question.reset();
        m_width = m_height = 0;
    }
    tell();
}

void MeshReference::tell()
{
    m_messages.set("reference", isShown() ? m_told : QList<Message>());
    if (isShown() && (m_width == 0 || m_background.busy()))
        m_messages.setNotice("tracing", tr("The error is against the flat relief until the displaced mesh has been traced."));
    else
        m_messages.clear("tracing");
}

void MeshReference::want(int width, int height)
{
    if (!isShown() || (width == m_width && height == m_height)) // also when it could not be made
        return;
    m_width = width, m_height = height;
    m_question = question();
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
                m_told = told, m_seen = seen;
                tell();
                Q_EMIT made();
            };
        });
    tell();
}

} // namespace relievo
