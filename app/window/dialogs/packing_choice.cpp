// Choosing and editing a packing preset.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/packing_choice.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/dialogs/packing_editor.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/theme.h"
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSettings>
#include <QToolButton>

namespace relievo {
namespace {
constexpr int kKept = 6; // files that are offered again
constexpr const char* kSetting = "export/packings";
} // namespace

PackingChoice::PackingChoice(QWidget* parent) : QWidget(parent), m_choices(new ChoiceList), m_edit(new QToolButton)
{
    m_choices->setObjectName("packing");
    m_choices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_edit->setObjectName("edit-packing");
    m_edit->setIcon(icon("own-target"));
    m_edit->setIconSize({16, 16});
    m_edit->setToolTip(tr("Edit the textures: which files, and what lies in their channels"));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2 * kGrid);
    line->addWidget(m_choices, 1);
    line->addWidget(m_edit);
    connect(m_choices, &QComboBox::activated, this, &PackingChoice::activated);
    connect(m_edit, &QToolButton::clicked, this, &PackingChoice::openEditor);
    offer();
}

// The target's own, files, and at the end how to choose another one. An item's data is its file.
void PackingChoice::offer()
{
    m_choices->clear();
    m_choices->addItem(tr("The target's own"), QString());
    for (const QString& file : QSettings().value(kSetting).toStringList()) {
        m_choices->addItem(QFileInfo(file).fileName(), file);
        m_choices->setItemData(m_choices->count() - 1, QDir::toNativeSeparators(file), Qt::ToolTipRole);
    }
    m_choices->addItem(tr("Choose a file..."));
    m_choices->setCurrentIndex(m_file.isEmpty() ? 0 : m_choices->findData(m_file));
    m_choices->setToolTip(m_file.isEmpty() ? tr("Textures to write in place of the target's") : QDir::toNativeSeparators(m_file));
}

void PackingChoice::activated(int item)
{
    if (item < m_choices->count() - 1)
        return setFile(m_choices->itemData(item).toString());
    offer(); // shows the present one until another is chosen
    askForFile(this, tr("Packing"), FileKind::Target, [this](const QString& file) { setFile(file); });
}

void PackingChoice::setFile(const QString& file)
{
    std::shared_ptr<const TargetText> packing;
    QStringList kept = QSettings().value(kSetting).toStringList();
    kept.removeAll(file);
    if (!file.isEmpty()) {
        auto read = readPacking(file.toStdString());
        if (!read) {
            offer();
            return Q_EMIT refused(read.error());
        }
        packing = std::make_shared<const TargetText>(std::move(*read));
        kept.prepend(file);
        QSettings().setValue(kSetting, QStringList(kept.mid(0, kKept)));
    }
    m_file = file;
    m_packing = packing;
    offer();
    Q_EMIT edited();
}

void PackingChoice::setTarget(const ExportRow& target)
{
    m_target = &target;
    setEnabled(!target.code);
}

void PackingChoice::openEditor()
{
    const std::vector<PackedTexture>& textures = m_packing ? m_packing->textures : textOf(*m_target).textures;
    auto* editor = new PackingEditor(textures, m_file, this);
    connect(editor, &PackingEditor::saved, this, &PackingChoice::setFile);
    editor->show();
}

} // namespace relievo
