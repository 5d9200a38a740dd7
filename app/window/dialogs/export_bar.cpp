// Laying out buttons and progress.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_bar.h"
#include "app/window/widgets/text.h"
#include "core/state/techniques.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace relievo {

ExportBar::ExportBar(QWidget* parent)
    : QWidget(parent)
    , m_which(new QLabel)
    , m_progress(new QProgressBar)
    , m_openFolder(button(tr("Open folder"), "open-folder", &ExportBar::folderWanted))
    , m_cancel(button(tr("Cancel"), "cancel", &ExportBar::stopWanted))
    , m_close(button(tr("Close"), "close", &ExportBar::closeWanted))
    , m_export(button(tr("Export"), "run", &ExportBar::exportWanted))
{
    m_which->setObjectName("which");
    m_which->setProperty("role", "dim");
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    m_progress->hide();
    m_openFolder->hide();
    m_cancel->hide();
    m_export->setDefault(true);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_which);
    line->addWidget(m_progress, 1);
    line->addStretch(1);
    for (QPushButton* one : {m_openFolder, m_cancel, m_close, m_export})
        line->addWidget(one);
}

QPushButton* ExportBar::button(const QString& text, const char* name, void (ExportBar::*wanted)())
{
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setAutoDefault(false);
    connect(made, &QPushButton::clicked, this, wanted);
    return made;
}

void ExportBar::showWhich(const State& state)
{
    m_which->setVisible(state.panes.size() > 1);
    if (const TechniqueRow* technique = findTechnique(state.panes.front().technique))
        m_which->setText(tr("Picture A (%1) is exported.").arg(qt(technique->label)));
}

void ExportBar::setBusy(bool busy)
{
    m_export->setEnabled(!busy);
    m_cancel->setVisible(busy);
    m_progress->setVisible(busy);
    m_progress->setValue(0);
}

void ExportBar::setProgress(float share)
{
    m_progress->setValue(int(share * 1000));
}

void ExportBar::offerFolder(bool on)
{
    m_openFolder->setVisible(on);
}

} // namespace relievo
