// Naming files before they are written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/file_list.h"
#include "app/window/dialogs/export_form.h"
#include "app/window/widgets/theme.h"
#include "core/exporters/file_sizes.h"
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

namespace relievo {
namespace {
constexpr int kLookedAfter = 150; // ms after the last change
constexpr int kLines = 5; // that are seen at once
enum FileColumn { NameColumn, SizeColumn, NoteColumn };

QString sizeText(double bytes)
{
    return QLocale(QLocale::English).formattedDataSize(qint64(bytes), bytes < 1e6 ? 0 : 1, QLocale::DataSizeSIFormat);
}

// With one digit: more would be made up.
QString aboutText(double bytes)
{
    if (bytes <= 0.)
        return FileList::tr("a few kB");
    const double digit = std::pow(10., std::floor(std::log10(bytes)));
    const double rounded = std::round(bytes / digit) * digit;
    return FileList::tr("about %1").arg(QLocale(QLocale::English).formattedDataSize(qint64(rounded), 0, QLocale::DataSizeSIFormat));
}
} // namespace

FileList::FileList(const ExportForm& form, const Document& document, const Assets& assets)
    : m_form(form)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
    , m_title(new QLabel(tr("Files")))
    , m_list(new QTreeWidget)
{
    m_title->setObjectName("files-title");
    m_title->setProperty("role", "dim");
    m_list->setObjectName("files");
    m_list->setColumnCount(3);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->setFixedHeight(kLines * (fontMetrics().height() + kGrid) + kGrid);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(SizeColumn, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(NoteColumn, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGrid);
    layout->addWidget(m_title);
    layout->addWidget(m_list);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kLookedAfter);
    connect(&m_rest, &QTimer::timeout, this, &FileList::look);
    connect(&form, &ExportForm::edited, this, &FileList::changed);
    connect(&assets, &Assets::resourcesChanged, this, &FileList::changed);
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & ~Changes(Change::Camera))
            changed();
    });
}

void FileList::showEvent(QShowEvent* event)
{
    m_rest.start();
    QWidget::showEvent(event);
}

void FileList::changed()
{
    if (isVisible())
        m_rest.start();
}

void FileList::look()
{
    const ExportChoice choice = m_form.choice();
    const Resources& resources = m_assets.resources();
    if (choice.out.isEmpty() || !resources.material || !resources.mesh) {
        m_background.cancel();
        return fill({}, false);
    }
    m_background.start([this, choice, state = m_document.state(), resources](const Progress& progress) -> Background::Then {
        const ExportJob job = choice.jobOf(state, resources, progress);
        std::vector<Line> lines;
        for (const std::filesystem::path& file : choice.target->writes(job)) {
            const QString path = QString::fromStdString(file.string());
            lines.push_back({path, aboutBytes(*choice.target, job, file), QFileInfo::exists(path)});
        }
        return [this, lines] { fill(lines, false); };
    });
}

void FileList::showWritten(const std::vector<std::filesystem::path>& files)
{
    m_rest.stop();
    m_background.cancel();
    std::vector<Line> lines;
    for (const std::filesystem::path& file : files) {
        const QString path = QString::fromStdString(file.string());
        lines.push_back({path, double(QFileInfo(path).size()), true});
    }
    fill(lines, true);
}

void FileList::fill(const std::vector<Line>& lines, bool isWritten)
{
    const QDir folder = QFileInfo(m_form.choice().out).isDir() || m_form.target().suffix.empty() ? QDir(m_form.choice().out)
                                                                                                 : QFileInfo(m_form.choice().out).dir();
    double sum = 0.;
    m_list->clear();
    for (const Line& line : lines) {
        auto* item = new QTreeWidgetItem(m_list,
            {folder.relativeFilePath(line.path), isWritten ? sizeText(line.bytes) : aboutText(line.bytes),
                isWritten          ? tr("written")
                    : line.isThere ? tr("is replaced")
                                   : QString()});
        item->setToolTip(NameColumn, QDir::toNativeSeparators(line.path));
        item->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
        item->setForeground(SizeColumn, dimText(palette()));
        item->setForeground(NoteColumn, !isWritten && line.isThere ? warningColor(palette()) : dimText(palette()));
        sum += line.bytes;
    }
    const QString count = lines.size() == 1 ? tr("1 file") : tr("%1 files").arg(lines.size());
    m_title->setText(lines.empty() ? tr("Files") : QString("%1, %2").arg(count, isWritten ? sizeText(sum) : aboutText(sum)));
}

} // namespace relievo
