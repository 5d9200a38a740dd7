// Turning cures on and off.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/cure_switches.h"
#include "app/window/widgets/switch.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QGridLayout>
#include <QLabel>
#include <QSettings>

namespace relievo {
namespace {
QString keyOf(Cure cure)
{
    return "export/cures/" + qt(wordOf(cure));
}
} // namespace

CureSwitches::CureSwitches(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid / 2);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < kChoices<Cure>; ++i) {
        const Cure cure = Cure(i);
        auto* button = m_switches[cure] = new Switch;
        auto* label = new QLabel(qt(kCures[cure].label));
        m_labels[cure] = label;
        button->setObjectName("cure-" + qt(wordOf(cure)));
        button->setChecked(QSettings().value(keyOf(cure), kCures[cure].byDefault).toBool());
        button->setAccessibleName(label->text());
        for (QWidget* part : {static_cast<QWidget*>(button), static_cast<QWidget*>(label)})
            part->setToolTip("<p>" + qt(kCures[cure].help).toHtmlEscaped() + "</p>");
        grid->addWidget(button, int(i), 0);
        grid->addWidget(label, int(i), 1);
        connect(button, &Switch::toggled, this, [this, cure](bool on) {
            QSettings().setValue(keyOf(cure), on);
            Q_EMIT edited();
        });
    }
}

EnumSet<Cure> CureSwitches::cures() const
{
    EnumSet<Cure> cures;
    for (std::size_t i = 0; i < kChoices<Cure>; ++i)
        if (m_switches[Cure(i)]->isChecked())
            cures.insert(Cure(i));
    return cures;
}

void CureSwitches::setUsed(EnumSet<Cure> used)
{
    for (std::size_t i = 0; i < kChoices<Cure>; ++i) {
        m_switches[Cure(i)]->setEnabled(used.contains(Cure(i)));
        m_labels[Cure(i)]->setEnabled(used.contains(Cure(i)));
    }
}

} // namespace relievo
