// Exporting from the window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/engine_label.h"
#include "app/window/dialogs/export_form.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QShowEvent>
#include <QTimer>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kResultHeight = 96; // px, of what is told under the form
constexpr int kToldFor = 30000; // ms that a success stands in the message line
} // namespace

ExportDialog::ExportDialog(const Document& document, const Assets& assets, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
    , m_form(new ExportForm(document))
    , m_which(new QLabel)
    , m_result(new QLabel)
    , m_export(new QPushButton(tr("Export")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_progress(new QProgressBar)
{
    setWindowTitle(tr("Export"));
    setObjectName("export");
    layOut();
    connect(m_form, &ExportForm::edited, m_result, &QWidget::hide); // it was of another name or target
    connect(&document, &Document::changed, this, &ExportDialog::showWhich);
    connect(&document, &Document::started, this, &ExportDialog::documentStarted);
    followExport();
    showWhich();
}

void ExportDialog::layOut()
{
    m_which->setObjectName("which");
    m_result->setWordWrap(true);
    m_result->setObjectName("result");
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_result->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_result->hide();
    auto* results = new QScrollArea; // its room is there from the start: the buttons under it stay where they are
    results->setWidgetResizable(true);
    results->setFixedHeight(kResultHeight);
    results->setWidget(m_result);
    m_export->setDefault(true);
    m_export->setObjectName("run");
    m_cancel->setAutoDefault(false);
    m_cancel->setObjectName("cancel");
    m_cancel->hide();
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    m_progress->hide();
    auto* close = new QPushButton(tr("Close"));
    close->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_progress, 1);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(close);
    buttons->addWidget(m_export);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(4 * kGrid);
    layout->addWidget(m_form);
    layout->addWidget(m_which);
    layout->addWidget(new EngineLabel(*m_form, m_document, m_assets));
    layout->addWidget(results);
    layout->addStretch(1);
    layout->addWidget(hairline());
    layout->addLayout(buttons);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::stop);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::run);
}

void ExportDialog::followExport()
{
    connect(&m_background, &Background::progressed, this, [this](float share) { m_progress->setValue(int(share * 1000)); });
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        written(m_form->typed(), failure(m_form->typed().toStdString(), what.toStdString(), "Nothing usable was written"));
    });
    connect(&m_background, &Background::busyChanged, this, [this](bool busy) {
        m_export->setEnabled(!busy);
        m_cancel->setVisible(busy);
        m_progress->setVisible(busy);
    });
}

void ExportDialog::showWhich()
{
    const State& state = m_document.state();
    m_which->setVisible(state.panes.size() > 1);
    if (const TechniqueRow* technique = findTechnique(state.panes.front().technique))
        m_which->setText(tr("Picture A (%1) is exported.").arg(qt(technique->label)));
}

void ExportDialog::setTarget(int row)
{
    m_form->setTarget(row);
}

void ExportDialog::setOut(const QString& path)
{
    m_form->setOut(path);
}

void ExportDialog::documentStarted()
{
    m_assets.messages().clear("export");
    m_form->forgetReplaceable();
    if (busy())
        return;
    m_result->hide();
    m_form->propose();
}

void ExportDialog::showEvent(QShowEvent* event)
{
    m_assets.messages().clear("export");
    if (!busy() && !event->spontaneous()) {
        m_result->hide(); // of the last time
        m_form->propose();
    }
    QDialog::showEvent(event);
}

void ExportDialog::run()
{
    if (busy())
        return;
    if (!m_assets.ready() || !m_assets.upToDate())
        return tell(failure(ErrorCode::NotReady, m_document.name().toStdString(), "its files are not loaded",
            "Wait until they are, or clear what is missing"));
    if (m_assets.missingMesh() && !m_assets.missingMesh()->asBefore) // what would be written is as deep as the mesh is large
        return tell(failure(ErrorCode::NotFound, m_document.state().mesh,
            "this mesh is not there, and its size decides the depth in metres", "Put it back, or choose another one"));
    const QString out = m_form->completePath(); // what is written is what is shown
    if (out.isEmpty())
        return tell(failure(tr("Where to").toStdString(), "no file is named", "Name one"));
    const QString taken
        = m_form->takenBy(m_form->target().writes(ExportJob{m_document.state(), m_assets.resources(), out.toStdString(), 0, {}}));
    if (!taken.isEmpty())
        return askToReplace(this, taken, [this, out] { write(out); });
    write(out);
}

void ExportDialog::write(const QString& out)
{
    for (const auto& file : m_form->target().writes(ExportJob{m_document.state(), m_assets.resources(), out.toStdString(), 0, {}}))
        m_form->allowReplacing(QString::fromStdString(file.string()));
    m_form->allowReplacing(out);
    m_result->hide();
    m_assets.messages().clear("export");
    m_background.start([this, row = m_form->target(), state = m_document.state(), resources = m_assets.resources(), out,
                           size = m_form->size(), project = m_document.file().toStdString()](const Progress& progress) -> Background::Then {
        const auto result = row.run(ExportJob{state, resources, out.toStdString(), size, progress, {project}});
        return [this, out, result] { written(out, result); };
    });
}

void ExportDialog::written(const QString& out, const Expected<Exported>& result)
{
    if (result) {
        ExportForm::rememberFolder(out);
        rememberSaved(out);
    }
    tell(result);
    if (isVisible())
        return;
    Messages& messages = m_assets.messages();
    if (!result)
        return messages.set("export", result.error());
    messages.setNotice("export", tr("Exported to %1.").arg(QDir::toNativeSeparators(out)));
    QTimer::singleShot(kToldFor, this, [this, &messages] { messages.clear("export"); });
}

void ExportDialog::stop()
{
    m_background.cancel();
    tell(failure(ErrorCode::Cancelled, m_form->typed().toStdString(), "the export was stopped",
        "Files that it had written by then are still there"));
}

void ExportDialog::tell(const Expected<Exported>& result)
{
    QStringList lines;
    if (result) {
        lines << tr("Written:");
        for (const auto& file : result->files)
            lines << QString::fromUtf8("\u2003") + QString::fromStdString(file.string());
        for (const Warning& warning : result->warnings)
            lines << tr("Note: %1").arg(QString::fromStdString(warning.text));
    } else {
        lines << QString::fromStdString(message(result.error()));
    }
    setRole(*m_result, result ? "" : "warning");
    m_result->setText(lines.join('\n'));
    m_result->show();
    Q_EMIT finished(result.has_value());
}

} // namespace relievo
