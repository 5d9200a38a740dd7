// Choosing size, path and cures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_form.h"
#include "app/window/dialogs/cure_switches.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/packing_choice.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
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

QLabel* helpLabel()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setProperty("role", "dim");
    label->setFont(smallFont());
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setFixedHeight(3 * QFontMetrics(label->font()).lineSpacing()); // of the longest: what is below stays where it is
    return label;
}
} // namespace

ExportForm::ExportForm(const Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_title(new QLabel)
    , m_help(helpLabel())
    , m_size(new ChoiceList)
    , m_out(new QLineEdit)
    , m_packing(new PackingChoice)
    , m_cures(new CureSwitches)
{
    m_title->setProperty("role", "heading");
    m_title->setObjectName("target");
    for (int size : kSizes)
        m_size->addItem(size == 0 ? tr("As the maps are") : tr("%1 texels").arg(size));
    m_out->setMinimumWidth(200);
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
    grid->addWidget(m_title, 0, 0, 1, 3);
    grid->addWidget(m_help, 1, 0, 1, 3);
    grid->addWidget(caption(tr("Where to")), 2, 0);
    grid->addWidget(m_out, 2, 1);
    grid->addWidget(browseButton, 2, 2);
    grid->addWidget(caption(tr("Textures")), 3, 0);
    grid->addWidget(m_size, 3, 1, 1, 2);
    grid->addWidget(caption(tr("Packing")), 4, 0);
    grid->addWidget(m_packing, 4, 1, 1, 2);
    grid->addWidget(m_cures, 5, 1, 1, 2);
    connect(m_out, &QLineEdit::textEdited, this, [this] {
        m_named = true;
        Q_EMIT edited();
    });
    connect(m_size, &QComboBox::currentIndexChanged, this, &ExportForm::edited);
    connect(m_cures, &CureSwitches::edited, this, &ExportForm::edited);
    connect(m_packing, &PackingChoice::edited, this, [this] {
        showUsedCures();
        Q_EMIT edited();
    });
    connect(m_packing, &PackingChoice::refused, this, &ExportForm::refused);
    connect(browseButton, &QToolButton::clicked, this, &ExportForm::browse);
}

void ExportForm::setTarget(const ExportRow& target)
{
    m_target = &target;
    m_title->setText(qt(target.label));
    m_help->setText(qt(target.help));
    m_packing->setTarget(target);
    showUsedCures();
    m_named = false;
    propose();
    Q_EMIT edited();
}

void ExportForm::showUsedCures()
{
    m_cures->setUsed(curesUsedBy(*m_target, m_packing->packing().get()));
}

ExportChoice ExportForm::choice() const
{
    return {m_target, completed(), kSizes[m_size->currentIndex()], m_cures->cures(), m_packing->packing()};
}

QString ExportForm::completed() const
{
    QString path = m_out->text().trimmed();
    if (path.isEmpty())
        return {};
    if (!m_target->takes(path.toStdString()))
        path += qt(m_target->suffix);
    return QDir::cleanPath(QDir(folderOfExports()).absoluteFilePath(path));
}

void ExportForm::complete()
{
    m_out->setText(completed());
}

void ExportForm::setOut(const QString& path)
{
    m_named = true;
    m_out->setText(path);
    Q_EMIT edited();
}

void ExportForm::propose()
{
    if (m_named)
        return;
    QString name = m_document.name().toLower();
    name.replace(' ', '_');
    m_out->setText(QDir(folderOfExports()).filePath(name + qt(m_target->suffix)));
}

void ExportForm::rememberFolder(const QString& path)
{
    QSettings().setValue("folders/export", QFileInfo(path).absolutePath());
}

void ExportForm::browse()
{
    if (m_target->suffix.empty())
        askForFile(this, tr("Export to folder"), FileKind::Folder, [this](const QString& folder) { setOut(folder); });
    else
        askWhereToSave(this, tr("Export to"), m_out->text(), {qt(m_target->suffix).mid(1)}, [this](const QString& file) {
            setOut(file);
            Q_EMIT chosenInBox(QFileInfo(file).absoluteFilePath());
        });
}

} // namespace relievo
