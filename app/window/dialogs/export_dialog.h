// The export dialog: a target of the export table, where to and how large; it works in the background and says what it wrote.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/exporters/exporters.h"
#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace relievo {

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
    const ExportRow& target() const;
    QString proposal() const;
    QString out() const; // as typed, made whole: absolute and with the target's suffix
    void targetChosen();
    void propose();
    void documentStarted();
    void browse();
    void write(const QString& out);
    void written(const QString& out, const Expected<Exported>& result);
    void stop();
    void tell(const Expected<Exported>& result);
    void showWhich();
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    QComboBox *m_target, *m_size;
    QLabel *m_help, *m_which, *m_result;
    QLineEdit* m_out;
    bool m_named = false; // the path was typed or chosen: it is not proposed anew
    QStringList m_replaceable; // chosen knowingly, or written from this document
    QPushButton *m_export, *m_cancel;
    QProgressBar* m_progress;
};

} // namespace relievo
