// The export dialog: a target of the export table, where to and how large; it works in the background and says what it wrote.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/exporters/exporters.h"
#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace relievo {

class ExportForm;

// Not modal: the picture can be changed meanwhile; what is exported is the document as it was when the button was pressed.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(const Document& document, const Assets& assets, QWidget* parent = nullptr);
    void setTarget(int row); // of kExports
    void setOut(const QString& path);
    bool busy() const { return m_background.busy(); }

public Q_SLOTS:
    // While the dialog is closed, the end is told in the message line.
    void run(); // asks first when something lies there that is not known to be replaceable

Q_SIGNALS:
    void finished(bool well);

protected:
    void showEvent(QShowEvent*) override;

private:
    void layOut();
    void followExport(); // its progress, end and failure
    void documentStarted();
    void write(const QString& out);
    void written(const QString& out, const Expected<Exported>& result);
    void stop();
    void tell(const Expected<Exported>& result);
    void showWhich();
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    ExportForm* m_form;
    QLabel *m_which, *m_result;
    QPushButton *m_export, *m_cancel;
    QProgressBar* m_progress;
};

} // namespace relievo
