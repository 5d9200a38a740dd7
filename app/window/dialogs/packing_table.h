// The table of a packing preset: a row a texture, which the parser of targets checks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/engines/target_text.h"
#include <QTableWidget>

namespace relievo {

class PackingTable : public QTableWidget {
    Q_OBJECT
public:
    explicit PackingTable(const std::vector<PackedTexture>& textures, QWidget* parent = nullptr);
    std::vector<PackedTexture> textures() const; // as typed: of channels the words alone
    void addNew(); // a row that is sound
    QString fault() const { return m_fault; } // of the first row that has one, with its number; "" when all are sound

Q_SIGNALS:
    void edited();

private:
    void addRow(const PackedTexture& texture);
    void removeRowOf(const QWidget& button);
    void check();
    QString faultOf(int row) const; // "" where it is sound
    QString m_fault;
};

} // namespace relievo
