// Exporting from the window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QToolButton>

namespace relievo {
namespace {
constexpr int kToldFor = 30000; // ms that a success stands in the message line
constexpr int kSizes[] = {0, 512, 1024, 2048, 4096}; // texels; 0 as the maps are

QLabel* caption(const QString& text)
{
    auto* label = new QLabel(text);
    label->setProperty("role", "dim");
    label->setFixedWidth(72);
    return label;
}

QString folderOfExports()
{
    return QSettings().value("folders/export", QDir::homePath()).toString();
}
} // namespace

ExportDialog::ExportDialog(const Document& document, const Assets& assets, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
    , m_target(new QComboBox)
    , m_size(new QComboBox)
    , m_help(new QLabel)
    , m_which(new QLabel)
    , m_result(new QLabel)
    , m_out(new QLineEdit)
    , m_export(new QPushButton(tr("Export")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_progress(new QProgressBar)
{
    setWindowTitle(tr("Export"));
    setObjectName("export");
    for (const ExportRow& row : kExports)
        m_target->addItem(qt(row.label));
    for (int size : kSizes)
        m_size->addItem(size == 0 ? tr("As the maps are") : tr("%1 texels").arg(size));
    m_help->setWordWrap(true);
    m_help->setProperty("role", "dim");
    m_help->setFont(smallFont());
    m_which->setObjectName("which");
    m_out->setMinimumWidth(320);
    m_out->setFixedHeight(kRowHeight);
    m_out->setObjectName("out");
    m_result->setWordWrap(true);
    m_result->setObjectName("result");
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_result->hide();
    m_export->setDefault(true);
    m_export->setObjectName("run");
    m_cancel->setAutoDefault(false);
    m_cancel->setObjectName("cancel");
    m_cancel->hide();
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    m_progress->hide();
    auto* browseButton = new QToolButton;
    browseButton->setIcon(icon("folder"));
    browseButton->setIconSize({16, 16});
    browseButton->setToolTip(tr("Choose where to"));
    auto* close = new QPushButton(tr("Close"));
    close->setAutoDefault(false);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(2 * kGrid);
    grid->addWidget(caption(tr("Target")), 0, 0);
    grid->addWidget(m_target, 0, 1, 1, 2);
    grid->addWidget(m_help, 1, 1, 1, 2);
    grid->addWidget(caption(tr("Textures")), 2, 0);
    grid->addWidget(m_size, 2, 1, 1, 2);
    grid->addWidget(caption(tr("Where to")), 3, 0);
    grid->addWidget(m_out, 3, 1);
    grid->addWidget(browseButton, 3, 2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_progress, 1);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(close);
    buttons->addWidget(m_export);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(4 * kGrid);
    layout->addLayout(grid);
    layout->addWidget(m_which);
    layout->addWidget(m_result);
    layout->addStretch(1);
    layout->addWidget(hairline());
    layout->addLayout(buttons);

    connect(m_target, &QComboBox::currentIndexChanged, this, &ExportDialog::targetChosen);
    connect(m_out, &QLineEdit::textEdited, this, [this] {
        m_named = true;
        m_result->hide(); // of another name
    });
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::stop);
    connect(&document, &Document::changed, this, &ExportDialog::showWhich);
    connect(&document, &Document::started, this, &ExportDialog::documentStarted);
    connect(browseButton, &QToolButton::clicked, this, &ExportDialog::browse);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::run);
    connect(&m_background, &Background::progressed, this, [this](float share) { m_progress->setValue(int(share * 1000)); });
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        written(m_out->text(), failure(m_out->text().toStdString(), what.toStdString(), "Nothing usable was written"));
    });
    connect(&m_background, &Background::busyChanged, this, [this](bool busy) {
        m_export->setEnabled(!busy);
        m_cancel->setVisible(busy);
        m_progress->setVisible(busy);
    });
    showWhich();
    targetChosen();
}

const ExportRow& ExportDialog::target() const
{
    return kExports[std::size_t(m_target->currentIndex())];
}

QString ExportDialog::proposal() const
{
    QString name = m_document.name().toLower();
    name.replace(' ', '_');
    return QDir(folderOfExports()).filePath(name + qt(target().suffix));
}

QString ExportDialog::out() const
{
    const QString typed = m_out->text().trimmed(), suffix = qt(target().suffix);
    if (typed.isEmpty())
        return {};
    return QDir::cleanPath(QDir(folderOfExports()).absoluteFilePath(typed.endsWith(suffix, Qt::CaseInsensitive) ? typed : typed + suffix));
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
    m_target->setCurrentIndex(row);
}

void ExportDialog::setOut(const QString& path)
{
    m_named = true;
    m_out->setText(path);
}

void ExportDialog::targetChosen()
{
    m_help->setText(qt(target().help));
    m_named = false;
    m_result->hide(); // of another target
    propose();
}

void ExportDialog::propose()
{
    if (!m_named)
        m_out->setText(proposal());
}

void ExportDialog::documentStarted()
{
    m_assets.messages().clear("export");
    m_replaceable.clear();
    if (busy())
        return;
    m_result->hide();
    propose();
}

void ExportDialog::showEvent(QShowEvent* event)
{
    m_assets.messages().clear("export");
    if (!busy() && !event->spontaneous()) {
        m_result->hide(); // of the last time
        propose();
    }
    QDialog::showEvent(event);
}

void ExportDialog::browse()
{
    if (target().suffix.empty())
        askForFile(this, tr("Export to folder"), FileKind::Folder, [this](const QString& folder) { setOut(folder); });
    else
        askWhereToSave(this, tr("Export to"), m_out->text(), qt(target().suffix).mid(1), [this](const QString& file) {
            setOut(file);
            m_replaceable.append(QFileInfo(file).absoluteFilePath()); // the chooser has asked
        });
}

void ExportDialog::run()
{
    if (busy())
        return;
    if (!m_assets.ready() || !m_assets.upToDate())
        return tell(failure(m_document.name().toStdString(), "its files are not loaded", "Wait until they are, or clear what is missing"));
    if (m_assets.missingMesh()) // what would be written is as deep as the mesh is large
        return tell(failure(m_document.state().mesh, "this mesh is not there, and its size decides the depth in metres",
            "Put it back, or choose another one"));
    const QString out = this->out();
    if (out.isEmpty())
        return tell(failure(tr("Where to").toStdString(), "no file is named", "Name one"));
    m_out->setText(out); // what is written is what is shown
    const QFileInfo there(out);
    const bool taken = there.isDir() ? !QDir(out).isEmpty() : there.exists();
    if (taken && !m_replaceable.contains(there.absoluteFilePath()))
        return askToReplace(this, out, [this, out] { write(out); });
    write(out);
}

void ExportDialog::write(const QString& out)
{
    m_replaceable.append(out);
    m_result->hide();
    m_assets.messages().clear("export");
    const int size = kSizes[m_size->currentIndex()];
    m_background.start([this, row = target(), state = m_document.state(), resources = m_assets.resources(), out, size](
                           const Progress& progress) -> Background::Then {
        const auto result = row.run(ExportJob{state, resources, out.toStdString(), size, progress});
        return [this, out, result] { written(out, result); };
    });
}

void ExportDialog::written(const QString& out, const Expected<Exported>& result)
{
    if (result) {
        QSettings().setValue("folders/export", QFileInfo(out).absolutePath());
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
    tell(failure(m_out->text().toStdString(), "the export was stopped", "Files that it had written by then are still there"));
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
    adjustSize();
    Q_EMIT finished(result.has_value());
}

} // namespace relievo
