// The files that an export will write, or has written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/exporters/exporters.h"
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <vector>

class QLabel;
class QTreeWidget;

namespace relievo {

class ExportForm;

// Named in the background while it is seen, when choice or document have changed and the hand rests; what lies there already is marked.
class FileList : public QWidget {
    Q_OBJECT
public:
    FileList(const ExportForm& form, const Document& document, const Assets& assets);
    void showWritten(const std::vector<std::filesystem::path>& files); // until something changes
    bool busy() const { return m_rest.isActive() || m_background.busy(); }

protected:
    void showEvent(QShowEvent*) override;

private:
    struct Line {
        QString path;
        double bytes = 0.; // 0: a small text
        bool isThere = false;
    };
    void changed();
    void look();
    void fill(const std::vector<Line>& lines, bool isWritten);
    const ExportForm& m_form;
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    QTimer m_rest;
    QLabel* m_title;
    QTreeWidget* m_list;
};

} // namespace relievo
