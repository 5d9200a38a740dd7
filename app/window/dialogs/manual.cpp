// The pages of resources/help, read where they are embedded.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/manual.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QDesktopServices>
#include <QDialog>
#include <QHBoxLayout>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextList>
#include <QTextTable>
#include <array>
#include <string_view>

namespace relievo {
namespace {
struct PageRow {
    std::string_view file, title;
};
constexpr auto kPages = std::to_array<PageRow>({
    {"lights.md", "Lights"},
    {"comparing.md", "Comparing techniques"},
    {"light.md", "Light and surroundings"},
    {"deciding.md", "Deciding on a technique"},
    {"camera.md", "Camera and picture"},
    {"optics.md", "Coat, cloth, glass"},
    {"targets.md", "Export targets"},
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

void open(QTextBrowser& text, const QUrl& page)
{
    text.setSource(page, QTextDocument::MarkdownResource);
    giveRoom(*text.document(), text.palette());
}

// A page of the manual here, anything else where the system opens it.
void follow(QTextBrowser& text, const QUrl& link)
{
    const QUrl url = text.source().resolved(link);
    if (url.scheme() == "qrc" && url.path().endsWith(".md"))
        open(text, url);
    else if (url.scheme() == "qrc" && url.hasFragment())
        text.scrollToAnchor(url.fragment());
    else if (url.scheme() != "qrc")
        QDesktopServices::openUrl(url);
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
    text->document()->setDocumentMargin(4 * kGrid);
    pages->setStyleSheet(QString("QListWidget::item { padding: %1px %2px; }").arg(kGrid).arg(2 * kGrid));
    for (const PageRow& row : kPages)
        pages->addItem(qt(row.title));
    QObject::connect(pages, &QListWidget::currentRowChanged, text, [text](int index) { open(*text, urlOf(kPages[std::size_t(index)])); });
    QObject::connect(text, &QTextBrowser::anchorClicked, text, [text](const QUrl& link) { follow(*text, link); });
    QObject::connect(text, &QTextBrowser::sourceChanged, pages, [pages](const QUrl& url) {
        const QSignalBlocker still(pages);
        for (std::size_t i = 0; i < kPages.size(); ++i)
            if (urlOf(kPages[i]).path() == url.path())
                pages->setCurrentRow(int(i));
    });
    pages->setCurrentRow(0);
    auto* line = new QHBoxLayout(dialog);
    line->addWidget(pages);
    line->addWidget(text, 1);
    dialog->show();
}

} // namespace relievo
