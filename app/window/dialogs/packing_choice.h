// Which textures are written: the target's own, or those of a packing preset.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/target_text.h"
#include <QWidget>
#include <memory>

class QComboBox;
class QToolButton;

namespace relievo {

// The files that were chosen before are offered; the settings keep the last few.
class PackingChoice : public QWidget {
    Q_OBJECT
public:
    explicit PackingChoice(QWidget* parent = nullptr);
    std::shared_ptr<const TargetText> packing() const { return isEnabled() ? m_packing : nullptr; } // null: the target's own
    void setTarget(const ExportRow& target); // one that code writes takes no packing
    void setFile(const QString& file); // "": the target's own

Q_SIGNALS:
    void edited();
    void refused(const relievo::Error& why); // a file that cannot be used

private:
    void offer();
    void activated(int item);
    void openEditor();
    const ExportRow* m_target = nullptr;
    QComboBox* m_choices;
    QToolButton* m_edit;
    QString m_file;
    std::shared_ptr<const TargetText> m_packing;
};

} // namespace relievo
