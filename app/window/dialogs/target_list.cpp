// Painting, searching and choosing targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/target_list.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/own_targets.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace relievo {
namespace {
constexpr int kHeadingHeight = 28, kEntryHeight = 40, kIcon = 20, kWidth = 248; // px
enum Role { Sentence = Qt::UserRole, IsHeading, IsFault }; // of an item
constexpr QLatin1String kOwn("own/"); // before the key of a target of the user's own

QString firstSentence(const QString& text)
{
    const qsizetype end = text.indexOf(". ");
    return end < 0 ? text : text.left(end + 1);
}

QString tip(const QString& text)
{
    return "<p>" + text.toHtmlEscaped() + "</p>";
}

// An icon beside a label over a sentence; a heading is small and dim.
class TargetDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        return {kWidth / 2, isHeading(index) ? kHeadingHeight : kEntryHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRect box = option.rect.adjusted(2 * kGrid, 0, -2 * kGrid, 0);
        if (isHeading(index)) {
            painter->setFont(smallFont());
            painter->setPen(dimText(option.palette));
            painter->drawText(box.adjusted(0, 0, 0, -kGrid), Qt::AlignLeft | Qt::AlignBottom, index.data().toString());
        } else {
            paintBack(*painter, option);
            paintEntry(*painter, option, index, box);
        }
        painter->restore();
    }

private:
    static bool isHeading(const QModelIndex& index) { return index.data(IsHeading).toBool(); }

    static void paintBack(QPainter& painter, const QStyleOptionViewItem& option)
    {
        const bool isChosen = option.state & QStyle::State_Selected;
        if (!isChosen && !(option.state & QStyle::State_MouseOver))
            return;
        painter.setPen(Qt::NoPen);
        painter.setBrush(isChosen ? hovered(option.palette) : raised(option.palette));
        painter.drawRoundedRect(QRectF(option.rect).adjusted(2, 1, -2, -1), 4, 4);
        if (isChosen) {
            painter.setBrush(accent(option.palette));
            painter.drawRoundedRect(QRectF(option.rect.left() + 2, option.rect.top() + 8, 3, option.rect.height() - 16), 1.5, 1.5);
        }
    }

    static void paintEntry(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, const QRect& box)
    {
        const QRect at(box.left() + kGrid, box.center().y() - kIcon / 2 + 1, kIcon, kIcon);
        index.data(Qt::DecorationRole).value<QIcon>().paint(&painter, at);
        const QRect text = box.adjusted(kIcon + 3 * kGrid, kGrid, 0, -kGrid);
        const auto line = [&](const QFont& font, const QColor& color, Qt::AlignmentFlag side, const QString& words) {
            painter.setFont(font);
            painter.setPen(color);
            painter.drawText(text, Qt::AlignLeft | side, QFontMetrics(font).elidedText(words, Qt::ElideRight, text.width()));
        };
        line(option.font, option.palette.color(QPalette::Text), Qt::AlignTop, index.data().toString());
        const bool isFault = index.data(IsFault).toBool();
        line(smallFont(), isFault ? warningColor(option.palette) : dimText(option.palette), Qt::AlignBottom,
            index.data(Sentence).toString());
    }
};
} // namespace

TargetList::TargetList(QWidget* parent)
    : QWidget(parent)
    , m_search(new QLineEdit)
    , m_list(new QListWidget)
    , m_none(new QLabel(tr("No target fits.")))
{
    m_search->setObjectName("search");
    m_search->setPlaceholderText(tr("Search targets"));
    m_search->setClearButtonEnabled(true);
    m_search->setFixedHeight(kRowHeight);
    m_search->installEventFilter(this);
    m_list->setObjectName("targets");
    m_list->setItemDelegate(new TargetDelegate(m_list));
    m_list->setMouseTracking(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_none->setProperty("role", "dim");
    m_none->setAlignment(Qt::AlignCenter);
    m_none->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2 * kGrid);
    layout->addWidget(m_search);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_none, 1);
    layout->addWidget(ownBar());
    setFixedWidth(kWidth);
    connect(m_search, &QLineEdit::textChanged, this, &TargetList::filter);
    connect(m_list, &QListWidget::currentRowChanged, this, &TargetList::lineChanged);
    fill();
}

QWidget* TargetList::ownBar()
{
    auto* bar = new QWidget;
    auto* addButton = new QPushButton(tr("Add a target..."));
    addButton->setObjectName("add-target");
    addButton->setAutoDefault(false);
    addButton->setToolTip(tip(tr("Takes a target of your own, a .tpl or .json file, into your folder of targets.")));
    auto* folder = new QToolButton;
    folder->setObjectName("targets-folder");
    folder->setIcon(icon("folder"));
    folder->setIconSize({16, 16});
    folder->setToolTip(tr("Open the folder of your own targets"));
    auto* line = new QHBoxLayout(bar);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(addButton, 1);
    line->addWidget(folder);
    connect(addButton, &QPushButton::clicked, this,
        [this] { askForFile(this, tr("Add a target"), FileKind::Target, [this](const QString& file) { add(file); }); });
    connect(folder, &QToolButton::clicked, this, &TargetList::openFolder);
    return bar;
}

void TargetList::addHeading(ExportGroup group)
{
    auto* item = new QListWidgetItem(qt(wordOf(group)), m_list);
    item->setFlags(Qt::NoItemFlags);
    item->setData(IsHeading, true);
    m_lines.push_back({nullptr, {}});
}

void TargetList::addRow(const ExportRow& row)
{
    auto* item = new QListWidgetItem(icon(row.icon), qt(row.label), m_list);
    item->setData(Sentence, firstSentence(qt(row.help)));
    item->setToolTip(tip(qt(row.help)));
    m_lines.push_back({&row, qt(row.label) + ' ' + qt(row.key) + ' ' + qt(row.help)});
}

void TargetList::addFault(const QString& file, const QString& fault)
{
    const QString name = QFileInfo(file).fileName();
    auto* item = new QListWidgetItem(icon("error"), name, m_list);
    item->setFlags(Qt::NoItemFlags);
    item->setData(Sentence, QString(fault).remove(file + ": "));
    item->setData(IsFault, true);
    item->setToolTip(tip(fault));
    m_lines.push_back({nullptr, name + ' ' + fault});
}

void TargetList::fill()
{
    const QSignalBlocker silent(m_list);
    m_list->clear();
    m_lines.clear();
    for (std::size_t i = 0; i < kChoices<ExportGroup>; ++i) {
        const auto isOfGroup = [i](const ExportRow& row) { return row.group == ExportGroup(i); };
        if (std::ranges::any_of(kExports, isOfGroup))
            addHeading(ExportGroup(i));
        for (const ExportRow& row : kExports)
            if (isOfGroup(row))
                addRow(row);
    }
    const std::vector<OwnTarget> own = ownTargets();
    if (!own.empty())
        addHeading(ExportGroup::Own);
    for (const OwnTarget& target : own)
        target.row ? addRow(*target.row) : addFault(target.file, target.fault);
    m_list->setCurrentRow(lineOf(*m_current));
    filter(m_search->text());
}

void TargetList::showEvent(QShowEvent* event)
{
    readOwn();
    QWidget::showEvent(event);
}

// The current one may be gone, or be another row since its file has changed.
void TargetList::readOwn()
{
    const QString name = currentName();
    fill();
    if (lineOf(*m_current) >= 0)
        return;
    setCurrent(name);
    if (lineOf(*m_current) < 0)
        setCurrent(qt(kExports.front().key));
}

void TargetList::add(const QString& file)
{
    const QString to = ownTargetPath(file);
    if (QFileInfo::exists(to) && QFileInfo(file).absoluteFilePath() != to)
        return askToReplace(this, to, [this, file] { take(file); });
    take(file);
}

void TargetList::take(const QString& file)
{
    const auto added = addOwnTarget(file);
    if (!added)
        return Q_EMIT refused(added.error());
    m_search->clear();
    readOwn();
    setCurrent(kOwn + QFileInfo(*added).completeBaseName());
    m_list->scrollToBottom();
}

void TargetList::openFolder()
{
    if (makeOwnTargetsFolder())
        QDesktopServices::openUrl(QUrl::fromLocalFile(ownTargetsFolder()));
}

int TargetList::lineOf(const ExportRow& row) const
{
    const auto found = std::ranges::find(m_lines, &row, &Line::row);
    return found == m_lines.end() ? -1 : int(found - m_lines.begin());
}

QString TargetList::currentName() const
{
    return (m_current->group == ExportGroup::Own ? kOwn : QLatin1String()) + qt(m_current->key);
}

void TargetList::setCurrent(const QString& name)
{
    const bool isOwn = name.startsWith(kOwn);
    const QString key = isOwn ? name.mid(kOwn.size()) : name;
    const auto found = std::ranges::find_if(
        m_lines, [&](const Line& line) { return line.row && qt(line.row->key) == key && (line.row->group == ExportGroup::Own) == isOwn; });
    if (found != m_lines.end())
        m_list->setCurrentRow(int(found - m_lines.begin()));
}

void TargetList::lineChanged(int line)
{
    const ExportRow* row = line < 0 ? nullptr : m_lines[std::size_t(line)].row;
    if (row && std::exchange(m_current, row) != row)
        Q_EMIT chosen();
}

// Each word stands in the label, the key or the help. A heading is seen with what stands under it.
void TargetList::filter(const QString& words)
{
    const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
    QListWidgetItem* heading = nullptr;
    bool any = false;
    for (int line = 0; line < m_list->count(); ++line) {
        QListWidgetItem* item = m_list->item(line);
        const QString& text = m_lines[std::size_t(line)].text;
        const bool fits
            = !text.isEmpty() && std::ranges::all_of(wanted, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
        item->setHidden(!fits);
        if (text.isEmpty())
            heading = item;
        else if (fits)
            heading->setHidden(false);
        any = any || fits;
    }
    m_list->setVisible(any);
    m_none->setVisible(!any);
    if (QListWidgetItem* current = m_list->currentItem(); current && !current->isHidden())
        m_list->scrollToItem(current);
}

void TargetList::takeFirst()
{
    if (const int line = lineOf(*m_current); line >= 0 && !m_list->item(line)->isHidden())
        return;
    for (int line = 0; line < m_list->count(); ++line)
        if (m_lines[std::size_t(line)].row && !m_list->item(line)->isHidden())
            return m_list->setCurrentRow(line);
}

// Arrows move through the list while words are typed; Enter takes the first that fits and does not export yet.
bool TargetList::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool moves = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    const bool takes = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (!moves && !takes)
        return QWidget::eventFilter(watched, event);
    const ExportRow* before = m_current;
    takeFirst();
    if (moves && m_current == before)
        QApplication::sendEvent(m_list, event);
    if (takes)
        m_list->setFocus(Qt::TabFocusReason);
    return true;
}

} // namespace relievo
