// The pages of resources/help, read where they are embedded.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/manual.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QDesktopServices>
#include <QDialog>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPointer>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextList>
#include <QTextTable>
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {
namespace {
struct PageRow {
    std::string_view file, title;
};
constexpr auto kPages = std::to_array<PageRow>({
    {"comparing.md", "Comparing techniques"},
    {"deciding.md", "Deciding on a technique"},
    {"lights.md", "Lights"},
    {"light.md", "Surroundings and floor"},
    {"camera.md", "Camera and picture"},
    {"optics.md", "Coat, cloth, glass"},
    {"targets.md", "Export targets"},
    {"objects.md", "Relief objects"},
    {"command-line.md", "The command line"},
    {"reference.md", "Reference"},
    {"speed-and-error.md", "Speed and error"},
    {"cell-cones.md", "Cell cones"},
    {"results.md", "Results"},
});

QUrl urlOf(const PageRow& row)
{
    return QUrl("qrc:/resources/help/" + qt(row.file));
}

// Markdown comes without room between paragraphs, and tables with lines around each cell.
void giveRoom(QTextDocument& page, const QPalette& palette)
{
    QTextCursor cursor(&page);
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        cursor.setPosition(block.position());
        if (cursor.currentTable())
            continue;
        QTextBlockFormat format = block.blockFormat();
        format.setTopMargin(format.headingLevel() > 0 ? 3 * kGrid : 0);
        format.setBottomMargin(block.textList() ? kGrid : 2 * kGrid);
        cursor.setBlockFormat(format);
    }
    for (QTextFrame* frame : page.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorderCollapse(true);
            format.setBorder(1);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(lineColor(palette));
            format.setCellPadding(kGrid);
            format.setBottomMargin(3 * kGrid);
            table->setFormat(format);
        }
}

// Made apart from the browser, which would lay it out anew for every row of every table.
void open(QTextBrowser& text, QListWidget& pages, const QUrl& url)
{
    QFile file(':' + url.path());
    const auto row = std::ranges::find(kPages, url, urlOf);
    if (row == kPages.end() || !file.open(QIODevice::ReadOnly))
        return;
    auto* page = new QTextDocument(&text);
    page->setBaseUrl(url);
    page->setDefaultFont(text.font());
    page->setDocumentMargin(4 * kGrid);
    page->setMarkdown(QString::fromUtf8(file.readAll()));
    giveRoom(*page, text.palette());
    const QPointer<QTextDocument> before = text.document();
    text.setDocument(page);
    if (before) // the browser's own is gone by now
        before->deleteLater();
    const QSignalBlocker still(&pages);
    pages.setCurrentRow(int(row - kPages.begin()));
}

// A page of the manual here, anything else where the system opens it.
void follow(QTextBrowser& text, QListWidget& pages, const QUrl& link)
{
    const QUrl here = text.document()->baseUrl(), url = here.resolved(link);
    if (url.scheme() != "qrc")
        return void(QDesktopServices::openUrl(url));
    if (url.path() != here.path())
        open(text, pages, url.adjusted(QUrl::RemoveFragment));
    if (url.hasFragment())
        text.scrollToAnchor(url.fragment());
}
} // namespace

void showManual(QWidget* parent)
{
    if (auto* open = parent->findChild<QDialog*>("manual")) {
        open->raise();
        return open->activateWindow();
    }
    auto* dialog = new QDialog(parent);
    dialog->setObjectName("manual");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QObject::tr("Manual"));
    dialog->resize(960, 680);
    auto* pages = new QListWidget;
    pages->setFixedWidth(200);
    pages->setAccessibleName(QObject::tr("Pages"));
    auto* text = new QTextBrowser;
    text->setOpenLinks(false);
    text->setAccessibleName(QObject::tr("Page"));
    pages->setStyleSheet(QString("QListWidget::item { padding: %1px %2px; }").arg(kGrid).arg(2 * kGrid));
    for (const PageRow& row : kPages)
        pages->addItem(qt(row.title));
    const auto openRow = [text, pages](int index) { open(*text, *pages, urlOf(kPages[std::size_t(index)])); };
    QObject::connect(pages, &QListWidget::currentRowChanged, text, openRow);
    QObject::connect(text, &QTextBrowser::anchorClicked, text, [text, pages](const QUrl& link) { follow(*text, *pages, link); });
    pages->setCurrentRow(0);
    auto* line = new QHBoxLayout(dialog);
    line->addWidget(pages);
    line->addWidget(text, 1);
    dialog->show();
}

} // namespace relievo
