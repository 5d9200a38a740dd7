// Choosing a target and a path.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_form.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QToolButton>

namespace relievo {
namespace {
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

ExportForm::ExportForm(const Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_target(new QComboBox)
    , m_size(new QComboBox)
    , m_help(new QLabel)
    , m_out(new QLineEdit)
{
    for (const ExportRow& row : kExports)
        m_target->addItem(qt(row.label));
    for (int size : kSizes)
        m_size->addItem(size == 0 ? tr("As the maps are") : tr("%1 texels").arg(size));
    m_help->setWordWrap(true);
    m_help->setProperty("role", "dim");
    m_help->setFont(smallFont());
    m_help->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_help->setFixedHeight(3 * QFontMetrics(m_help->font()).lineSpacing()); // of the longest: what is below stays where it is
    m_out->setMinimumWidth(320);
    m_out->setFixedHeight(kRowHeight);
    m_out->setObjectName("out");
    auto* browseButton = new QToolButton;
    browseButton->setIcon(icon("folder"));
    browseButton->setIconSize({16, 16});
    browseButton->setToolTip(tr("Choose where to"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
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
    connect(m_target, &QComboBox::currentIndexChanged, this, &ExportForm::targetChosen);
    connect(m_out, &QLineEdit::textEdited, this, [this] {
        m_named = true;
        Q_EMIT edited();
    });
    connect(browseButton, &QToolButton::clicked, this, &ExportForm::browse);
    targetChosen();
}

const ExportRow& ExportForm::target() const
{
    return kExports[std::size_t(m_target->currentIndex())];
}

void ExportForm::setTarget(int row)
{
    m_target->setCurrentIndex(row);
}

int ExportForm::size() const
{
    return kSizes[m_size->currentIndex()];
}

QString ExportForm::typed() const
{
    return m_out->text();
}

QString ExportForm::completePath()
{
    QString path = m_out->text().trimmed();
    if (path.isEmpty())
        return {};
    if (const QString suffix = qt(target().suffix); !path.endsWith(suffix, Qt::CaseInsensitive))
        path += suffix;
    path = QDir::cleanPath(QDir(folderOfExports()).absoluteFilePath(path));
    m_out->setText(path);
    return path;
}

QString ExportForm::takenBy(const std::vector<std::filesystem::path>& files) const
{
    const QFileInfo out(m_out->text());
    if (mayReplace(out.absoluteFilePath()) && out.isDir())
        return {};
    if (out.isDir() && !QDir(out.absoluteFilePath()).isEmpty())
        return out.absoluteFilePath();
    for (const std::filesystem::path& file : files)
        if (const QString path = QString::fromStdString(file.string()); QFileInfo::exists(path) && !mayReplace(path))
            return path;
    return {};
}

void ExportForm::setOut(const QString& path)
{
    m_named = true;
    m_out->setText(path);
}

void ExportForm::propose()
{
    if (m_named)
        return;
    QString name = m_document.name().toLower();
    name.replace(' ', '_');
    m_out->setText(QDir(folderOfExports()).filePath(name + qt(target().suffix)));
}

void ExportForm::rememberFolder(const QString& path)
{
    QSettings().setValue("folders/export", QFileInfo(path).absolutePath());
}

void ExportForm::targetChosen()
{
    m_help->setText(qt(target().help));
    m_named = false;
    propose();
    Q_EMIT edited();
}

void ExportForm::browse()
{
    if (target().suffix.empty())
        askForFile(this, tr("Export to folder"), FileKind::Folder, [this](const QString& folder) { setOut(folder); });
    else
        askWhereToSave(this, tr("Export to"), m_out->text(), qt(target().suffix).mid(1), [this](const QString& file) {
            setOut(file);
            allowReplacing(QFileInfo(file).absoluteFilePath()); // the chooser has asked
        });
}

} // namespace relievo
