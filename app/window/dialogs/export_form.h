// What is exported as which target, how large and where to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "core/exporters/exporters.h"
#include <QStringList>
#include <QWidget>
#include <filesystem>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;

namespace relievo {

// Proposes a path by the document's name, until one is typed or chosen.
class ExportForm : public QWidget {
    Q_OBJECT
public:
    explicit ExportForm(const Document& document, QWidget* parent = nullptr);
    const ExportRow& target() const;
    void setTarget(int row); // of kExports
    int size() const; // texels; 0: as the maps are
    QString typed() const; // the path as it stands there
    QString completePath(); // makes it absolute and gives it the target's suffix; "" when none is typed
    void setOut(const QString& path);
    void propose();

    // Whether what lies at `path` was chosen knowingly, or was written from this document.
    bool mayReplace(const QString& path) const { return m_replaceable.contains(path); }
    // The first of what an export to the completed path writes over that may not be replaced unasked, or the folder that it mixes its
    // files into; "" when there is none.
    QString takenBy(const std::vector<std::filesystem::path>& files) const;
    void allowReplacing(const QString& path) { m_replaceable.append(path); }
    void forgetReplaceable() { m_replaceable.clear(); }
    static void rememberFolder(const QString& path); // for the next proposals

Q_SIGNALS:
    void edited(); // another target, or another path was typed

private:
    void targetChosen();
    void browse();
    const Document& m_document;
    QComboBox *m_target, *m_size;
    QLabel* m_help;
    QLineEdit* m_out;
    bool m_named = false; // the path was typed or chosen: it is not proposed anew
    QStringList m_replaceable;
};

} // namespace relievo
