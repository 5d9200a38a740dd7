// Rows of fields, from textures and back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/packing_table.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/switch.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>

namespace relievo {
namespace {
enum Column { Fault, Key, Name, Format, Red, Green, Blue, Alpha, Bits, Srgb, When, Remove, Count };
constexpr int kWidths[] = {24, 112, 130, 72, 112, 112, 112, 112, 56, 48, 112, 28}; // px, of the columns

QComboBox* choice(const QStringList& words, const QString& current)
{
    auto* list = new ChoiceList;
    list->addItems(words);
    if (list->findText(current) < 0)
        list->addItem(current);
    list->setCurrentText(current);
    return list;
}

// Its words, and any number that is typed.
QComboBox* channelChoice(const QString& current)
{
    static const QStringList words = [] {
        QStringList all{""};
        for (const std::string& word : channelWords())
            all << QString::fromStdString(word);
        return all << "0.0"
                   << "0.5"
                   << "1.0";
    }();
    QComboBox* list = choice(words, current);
    list->setEditable(true);
    list->setInsertPolicy(QComboBox::NoInsert);
    return list;
}

template <class Words, class Text> QStringList listOf(const Words& words, Text text)
{
    QStringList list;
    for (const auto& word : words)
        list << text(word);
    return list;
}
QStringList whens()
{
    QStringList list;
    for (std::size_t i = 0; i < kChoices<PackedTexture::When>; ++i)
        list << qt(wordOf(PackedTexture::When(i)));
    return list;
}

QString typed(const QTableWidget& table, int row, int column)
{
    const QWidget* cell = table.cellWidget(row, column);
    if (const auto* list = qobject_cast<const QComboBox*>(cell))
        return list->currentText().trimmed();
    if (const auto* text = qobject_cast<const QLineEdit*>(cell))
        return text->text().trimmed();
    return {};
}

PackedTexture textureAt(const QTableWidget& table, int row)
{
    PackedTexture texture;
    texture.key = typed(table, row, Key).toStdString();
    texture.file = (typed(table, row, Name) + typed(table, row, Format)).toStdString();
    int last = Alpha;
    while (last > Red && typed(table, row, last).isEmpty())
        --last;
    for (int column = Red; column <= last; ++column)
        texture.channels.push_back({.word = typed(table, row, column).toStdString()});
    texture.bits = typed(table, row, Bits).toInt();
    texture.srgb = qobject_cast<const Switch*>(table.cellWidget(row, Srgb))->isChecked();
    texture.when = *choiceOf<PackedTexture::When>(typed(table, row, When).toStdString());
    return texture;
}

// The parser's sentence without the place, which the row says.
QString faultIn(const std::vector<PackedTexture>& textures)
{
    const auto read = parseTarget(packingText(textures), "packing", false);
    if (read)
        return {};
    const QString member = QString::fromStdString(read.error().where).section('.', -1);
    return member + ' ' + QString::fromStdString(read.error().what).section(';', 0, 0); // without the list of all channels
}
} // namespace

PackingTable::PackingTable(const std::vector<PackedTexture>& textures, QWidget* parent) : QTableWidget(0, Count, parent)
{
    setObjectName("textures");
    setHorizontalHeaderLabels({"", tr("Key"), tr("File"), tr("Format"), tr("Red"), tr("Green"), tr("Blue"), tr("Alpha"), tr("Bits"),
        tr("sRGB"), tr("Written"), ""});
    verticalHeader()->hide();
    setShowGrid(false);
    setSelectionMode(QAbstractItemView::NoSelection);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->setDefaultSectionSize(kRowHeight + kGrid);
    horizontalHeader()->setMinimumSectionSize(kWidths[Fault]);
    for (int column = 0; column < Count; ++column)
        setColumnWidth(column, kWidths[column]);
    horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const PackedTexture& texture : textures)
        addRow(texture);
    check();
}

void PackingTable::addRow(const PackedTexture& texture)
{
    const int row = rowCount();
    insertRow(row);
    const QString file = QString::fromStdString(texture.file), suffix = '.' + QFileInfo(file).suffix();
    const auto put = [&](int column, QWidget* cell) {
        setCellWidget(row, column, cell);
        if (auto* list = qobject_cast<QComboBox*>(cell))
            connect(list, &QComboBox::currentTextChanged, this, &PackingTable::check);
        if (auto* text = qobject_cast<QLineEdit*>(cell)) {
            text->setCursorPosition(0);
            connect(text, &QLineEdit::textChanged, this, &PackingTable::check);
        }
    };
    auto* mark = new QLabel;
    mark->setAlignment(Qt::AlignCenter);
    put(Fault, mark);
    put(Key, new QLineEdit(QString::fromStdString(texture.key)));
    put(Name, new QLineEdit(file.chopped(suffix.size())));
    put(Format, choice(listOf(kTextureSuffixes, qt), suffix));
    for (int c = 0; c < 4; ++c) {
        const bool isThere = std::size_t(c) < texture.channels.size();
        put(Red + c, channelChoice(isThere ? QString::fromStdString(texture.channels[std::size_t(c)].word) : QString()));
    }
    put(Bits, choice(listOf(kTextureBits, [](int bits) { return QString::number(bits); }), QString::number(texture.bits)));
    auto* srgb = new Switch;
    srgb->setChecked(texture.srgb);
    put(Srgb, srgb);
    put(When, choice(whens(), qt(wordOf(texture.when))));
    auto* remove = new QToolButton;
    remove->setObjectName("remove");
    remove->setIcon(icon("clear"));
    remove->setIconSize({12, 12});
    remove->setToolTip(tr("Remove this texture"));
    put(Remove, remove);
    connect(remove, &QToolButton::clicked, this, [this, remove] { removeRowOf(*remove); });
}

void PackingTable::addNew()
{
    PackedTexture texture;
    for (int n = rowCount() + 1; texture.key.empty(); ++n) {
        const std::string key = "texture" + std::to_string(n);
        if (std::ranges::none_of(textures(), [&](const PackedTexture& other) { return other.key == key; }))
            texture.key = key;
    }
    texture.file = "{{name}}_" + texture.key + ".png";
    texture.channels = {{.word = "height"}};
    addRow(texture);
    check();
    cellWidget(rowCount() - 1, Key)->setFocus();
}

void PackingTable::removeRowOf(const QWidget& button)
{
    int row = 0;
    while (cellWidget(row, Remove) != &button)
        ++row;
    removeRow(row);
    check();
}

std::vector<PackedTexture> PackingTable::textures() const
{
    std::vector<PackedTexture> all;
    for (int row = 0; row < rowCount(); ++row)
        all.push_back(textureAt(*this, row));
    return all;
}

QString PackingTable::faultOf(int row) const
{
    const std::vector<PackedTexture> all = textures();
    const PackedTexture& own = all[std::size_t(row)];
    if (const QString fault = faultIn({own}); !fault.isEmpty())
        return fault;
    for (int other = 0; other < row; ++other)
        if (all[std::size_t(other)].key == own.key)
            return faultIn({own, own});
    return {};
}

void PackingTable::check()
{
    m_fault.clear();
    for (int row = 0; row < rowCount(); ++row) {
        const QString fault = faultOf(row);
        auto* mark = qobject_cast<QLabel*>(cellWidget(row, Fault));
        mark->setPixmap(fault.isEmpty() ? QPixmap() : icon("error").pixmap(QSize(16, 16), devicePixelRatioF()));
        mark->setToolTip(fault);
        if (m_fault.isEmpty() && !fault.isEmpty())
            m_fault = tr("Line %1: %2.").arg(row + 1).arg(fault);
    }
    if (rowCount() == 0)
        m_fault = tr("A packing holds one texture at least.");
    Q_EMIT edited();
}

} // namespace relievo
