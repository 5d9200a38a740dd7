// Measuring what an engine draws.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/engine_label.h"
#include "app/window/dialogs/export_form.h"
#include "app/window/widgets/theme.h"

namespace relievo {
namespace {
constexpr int kMeasuredAfter = 200; // ms after the last change
}

EngineLabel::EngineLabel(const ExportForm& form, const Document& document, const Assets& assets)
    : m_form(form)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
{
    setObjectName("drawing");
    setWordWrap(true);
    setFont(smallFont());
    setFixedHeight(2 * QFontMetrics(font()).lineSpacing()); // what is below stays where it is
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kMeasuredAfter);
    const auto changed = [this] {
        if (isVisible())
            m_rest.start();
    };
    connect(&form, &ExportForm::edited, this, changed);
    connect(&document, &Document::changed, this, [changed](Changes what) {
        if (what != Changes(Change::Camera))
            changed();
    });
    connect(&m_rest, &QTimer::timeout, this, &EngineLabel::measure);
}

void EngineLabel::showEvent(QShowEvent* event)
{
    m_rest.start();
    QLabel::showEvent(event);
}

void EngineLabel::measure()
{
    const Resources& resources = m_assets.resources();
    if (!m_assets.ready() || !m_assets.upToDate() || !resources.material || !resources.mesh)
        return clear();
    m_background.start(
        [this, choice = m_form.choice(), state = m_document.state(), resources](const Progress& progress) -> Background::Then {
            const QString told = QString::fromStdString(drawingTold(*choice.target, choice.jobOf(state, resources, progress)));
            return [this, told] { setText(told.isEmpty() ? told : told + '.'); };
        });
}

} // namespace relievo
