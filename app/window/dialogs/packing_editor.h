// Editing a packing preset: which textures are written, and what lies in each channel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/target_text.h"
#include <QDialog>

class QLabel;
class QPushButton;

namespace relievo {

class PackingTable;

// What is saved is what the command line reads (parseTarget); while a row has a fault nothing is. Deletes itself when closed.
class PackingEditor : public QDialog {
    Q_OBJECT
public:
    // file: that the textures are of, proposed when they are saved; "" for none.
    PackingEditor(const std::vector<PackedTexture>& textures, QString file, QWidget* parent);
    bool saveTo(const QString& file); // whether it could be written; else it is told

Q_SIGNALS:
    void saved(const QString& file);

private:
    void layOut();
    void showFault();
    void save();
    QString m_file;
    PackingTable* m_table;
    QLabel* m_fault;
    QPushButton* m_save;
};

} // namespace relievo
