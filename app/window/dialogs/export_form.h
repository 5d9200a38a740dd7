// How a target is exported: how large, where to, and with which cures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/dialogs/export_run.h"
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;

namespace relievo {

class CureSwitches;
class PackingChoice;

// Proposes a path by the document's name, until one is typed or chosen.
class ExportForm : public QWidget {
    Q_OBJECT
public:
    explicit ExportForm(const Document& document, QWidget* parent = nullptr);
    const ExportRow& target() const { return *m_target; }
    void setTarget(const ExportRow& target);
    ExportChoice choice() const; // its path as `complete` would make it
    void complete(); // the path that is shown becomes absolute, with the target's suffix; an empty one stays
    void setOut(const QString& path);
    void propose();
    static void rememberFolder(const QString& path); // for the next proposals

Q_SIGNALS:
    void edited(); // another choice
    void refused(const relievo::Error& why); // a packing that cannot be used
    void chosenInBox(const QString& path); // the file chooser has asked whether it may be replaced

private:
    QString completed() const;
    void showUsedCures();
    void browse();
    const Document& m_document;
    const ExportRow* m_target = nullptr;
    QLabel *m_title, *m_help;
    QComboBox* m_size;
    QLineEdit* m_out;
    PackingChoice* m_packing;
    CureSwitches* m_cures;
    bool m_named = false; // the path was typed or chosen: it is not proposed anew
};

} // namespace relievo
