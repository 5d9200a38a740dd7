// The table of a packing with its buttons.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/packing_editor.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/packing_table.h"
#include "app/window/widgets/theme.h"
#include "core/ground/file.h"
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>

namespace relievo {
namespace {
constexpr QSize kEditorSize(1120, 420); // px, where the screen has room for it
}

PackingEditor::PackingEditor(const std::vector<PackedTexture>& textures, QString file, QWidget* parent)
    : QDialog(parent)
    , m_file(std::move(file))
    , m_table(new PackingTable(textures))
    , m_fault(new QLabel)
    , m_save(new QPushButton(tr("Save as...")))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("packing-editor");
    setWindowTitle(m_file.isEmpty() ? tr("Packing") : tr("Packing: %1").arg(QFileInfo(m_file).fileName()));
    layOut();
    connect(m_table, &PackingTable::edited, this, &PackingEditor::showFault);
    showFault();
}

void PackingEditor::layOut()
{
    m_fault->setObjectName("fault");
    m_fault->setWordWrap(true);
    m_fault->setFixedHeight(2 * fontMetrics().lineSpacing());
    m_fault->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* addButton = new QPushButton(tr("Add a texture"));
    addButton->setObjectName("add");
    m_save->setObjectName("save");
    m_save->setDefault(true);
    auto* close = new QPushButton(tr("Close"));
    for (QPushButton* button : {addButton, close})
        button->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(addButton);
    buttons->addStretch(1);
    buttons->addWidget(close);
    buttons->addWidget(m_save);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(3 * kGrid);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_fault);
    layout->addLayout(buttons);
    resize(kEditorSize.boundedTo(screen()->availableSize() - QSize(32, 64)));
    connect(addButton, &QPushButton::clicked, m_table, &PackingTable::addNew);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_save, &QPushButton::clicked, this, &PackingEditor::save);
}

void PackingEditor::showFault()
{
    const QString fault = m_table->fault();
    setRole(*m_fault, fault.isEmpty() ? "dim" : "warning");
    m_fault->setText(fault.isEmpty() ? tr("{{name}} stands for the material's name. A texture is written when the material has one of "
                                          "its maps; a channel without its map holds a neutral value.")
                                     : fault);
    m_save->setEnabled(fault.isEmpty());
}

void PackingEditor::save()
{
    const QString proposal = m_file.endsWith(".json") ? m_file : "packing.json";
    askWhereToSave(this, tr("Save the packing"), proposal, {"json"}, [this](const QString& file) { saveTo(file); });
}

bool PackingEditor::saveTo(const QString& file)
{
    if (const auto written = writeAtomically(file.toStdString(), packingText(m_table->textures())); !written) {
        setRole(*m_fault, "warning");
        m_fault->setText(QString::fromStdString(message(written.error())));
        return false;
    }
    rememberSaved(file);
    m_file = file;
    Q_EMIT saved(file);
    close();
    return true;
}

} // namespace relievo
