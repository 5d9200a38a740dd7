// Exporting from the window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/engine_label.h"
#include "app/window/dialogs/engine_pictures.h"
#include "app/window/dialogs/export_bar.h"
#include "app/window/dialogs/export_form.h"
#include "app/window/dialogs/file_list.h"
#include "app/window/dialogs/target_list.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QDir>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QShowEvent>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kResultHeight = 72; // px, of what is told under the form
constexpr QSize kSize(880, 820); // px, where the screen has room for it
constexpr const char* kTargetKey = "export/target"; // of the settings

// Scrolls up and down where there is no room.
QScrollArea* scrolling(QWidget* what)
{
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(what);
    return area;
}
} // namespace

ExportDialog::ExportDialog(const Document& document, const Assets& assets, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_assets(assets)
    , m_run(document, assets)
    , m_targets(new TargetList)
    , m_form(new ExportForm(document))
    , m_files(new FileList(*m_form, document, assets))
    , m_result(new QLabel)
    , m_bar(new ExportBar)
{
    setWindowTitle(tr("Export"));
    setObjectName("export");
    m_run.setParent(this);
    m_run.tellInLine(true);
    m_targets->setCurrent(QSettings().value(kTargetKey).toString());
    m_form->setTarget(m_targets->current());
    layOut();
    connect(m_targets, &TargetList::chosen, this, &ExportDialog::targetChosen);
    connect(m_targets, &TargetList::refused, this, [this](const Error& why) { tell(tl::unexpected(why)); });
    connect(m_form, &ExportForm::edited, this, &ExportDialog::forget); // it was of another name or target
    connect(m_form, &ExportForm::refused, this, [this](const Error& why) { tell(tl::unexpected(why)); });
    connect(m_form, &ExportForm::chosenInBox, &m_run, &ExportRun::allowReplacing);
    connect(&document, &Document::changed, this, [this] { m_bar->showWhich(m_document.state()); });
    connect(&document, &Document::started, this, &ExportDialog::documentStarted);
    followExport();
    m_bar->showWhich(document.state());
}

void ExportDialog::layOut()
{
    m_result->setWordWrap(true);
    m_result->setObjectName("result");
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_result->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_result->hide();
    auto* results = scrolling(m_result); // its room is there from the start: the buttons under it stay where they are
    results->setFixedHeight(kResultHeight);
    auto* right = new QVBoxLayout;
    right->setSpacing(3 * kGrid);
    right->addWidget(scrolling(details()), 1);
    right->addWidget(results);
    auto* both = new QHBoxLayout;
    both->setSpacing(4 * kGrid);
    both->addWidget(m_targets);
    both->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(3 * kGrid);
    layout->addLayout(both, 1);
    layout->addWidget(hairline());
    layout->addWidget(m_bar);
    resize(kSize.boundedTo(screen()->availableSize() - QSize(32, 64)));
}

QWidget* ExportDialog::details()
{
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 2 * kGrid, 0);
    layout->setSpacing(3 * kGrid);
    layout->addWidget(m_form);
    layout->addWidget(new EnginePictures(*m_form, m_document, m_assets));
    layout->addWidget(new EngineLabel(*m_form, m_document, m_assets));
    layout->addWidget(m_files);
    layout->addStretch(1);
    return page;
}

void ExportDialog::followExport()
{
    connect(m_bar, &ExportBar::closeWanted, this, &QDialog::close);
    connect(m_bar, &ExportBar::stopWanted, &m_run, &ExportRun::stop);
    connect(m_bar, &ExportBar::exportWanted, this, &ExportDialog::run);
    connect(m_bar, &ExportBar::folderWanted, this, [this] {
        if (m_run.last())
            openFolderOf(*m_run.last());
    });
    connect(&m_run, &ExportRun::progressed, m_bar, &ExportBar::setProgress);
    connect(&m_run, &ExportRun::busyChanged, m_bar, &ExportBar::setBusy);
    connect(&m_run, &ExportRun::ended, this, [this](const ExportEnd& end) {
        if (end.result)
            ExportForm::rememberFolder(end.choice.out);
        m_bar->offerFolder(end.result.has_value());
        tell(end.result);
    });
}

void ExportDialog::setTarget(std::string_view key)
{
    m_targets->setCurrent(qt(key));
}

void ExportDialog::targetChosen()
{
    m_form->setTarget(m_targets->current());
    QSettings().setValue(kTargetKey, m_targets->currentName());
}

void ExportDialog::setOut(const QString& path)
{
    m_form->setOut(path);
}

void ExportDialog::forget()
{
    m_result->hide();
    m_bar->offerFolder(false);
}

void ExportDialog::documentStarted()
{
    if (busy())
        return;
    forget();
    m_form->propose();
}

void ExportDialog::present()
{
    show();
    raise();
}

void ExportDialog::showEvent(QShowEvent* event)
{
    m_assets.messages().clear("export");
    m_run.tellInLine(false);
    if (!busy() && !event->spontaneous()) {
        forget(); // what was of the last time
        m_form->propose();
    }
    QDialog::showEvent(event);
}

void ExportDialog::hideEvent(QHideEvent* event)
{
    if (!event->spontaneous())
        m_run.tellInLine(true);
    QDialog::hideEvent(event);
}

void ExportDialog::run()
{
    m_form->complete(); // what is written is what is shown
    const ExportChoice choice = m_form->choice();
    if (const auto ready = m_run.ready(); !ready)
        return tell(tl::unexpected(ready.error()));
    if (choice.out.isEmpty())
        return tell(failure(tr("Where to").toStdString(), "no file is named", "Name one"));
    askAndStart(choice);
}

void ExportDialog::runAgain()
{
    if (!m_run.last())
        return present();
    if (const auto ready = m_run.ready(); !ready)
        return m_assets.messages().set("export", ready.error());
    askAndStart(*m_run.last());
}

void ExportDialog::askAndStart(const ExportChoice& choice)
{
    if (busy())
        return;
    const auto start = [this, choice] {
        forget();
        m_run.start(choice);
    };
    if (const QString taken = m_run.takenBy(choice); !taken.isEmpty())
        return askToReplace(isVisible() ? this : parentWidget(), taken, start);
    start();
}

void ExportDialog::tell(const Expected<Exported>& result)
{
    QStringList lines;
    if (result) {
        m_files->showWritten(result->files);
        lines << tr("Exported to %1.").arg(QDir::toNativeSeparators(m_run.last()->out));
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
