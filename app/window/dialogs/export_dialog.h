// The export dialog: a target of the list, how and where to; it works in the background and says what it wrote.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/dialogs/export_run.h"
#include <QDialog>

class QLabel;

namespace relievo {

class ExportBar;
class ExportForm;
class FileList;
class TargetList;

// Not modal: the picture can be changed meanwhile; what is exported is the document as it was when the button was pressed.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(const Document& document, const Assets& assets, QWidget* parent = nullptr);
    void present(); // shows it, before other windows
    void setTarget(std::string_view key);
    void setOut(const QString& path);
    bool busy() const { return m_run.busy(); }

public Q_SLOTS:
    // While the dialog is closed, progress and end are told in the message line.
    void run(); // asks first when something lies there that is not known to be replaceable
    void runAgain(); // as the last time that this document was exported; when it was not, the dialog is shown

Q_SIGNALS:
    void finished(bool well);

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void layOut();
    QWidget* details(); // of the target that is chosen
    void followExport(); // its buttons, progress, end and failure
    void targetChosen();
    void documentStarted();
    void askAndStart(const ExportChoice& choice);
    void tell(const Expected<Exported>& result);
    void forget(); // what was told
    const Document& m_document;
    const Assets& m_assets;
    ExportRun m_run;
    TargetList* m_targets;
    ExportForm* m_form;
    FileList* m_files;
    QLabel* m_result;
    ExportBar* m_bar;
};

} // namespace relievo
