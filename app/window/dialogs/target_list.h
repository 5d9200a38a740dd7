// The targets of an export in groups, with a field that searches them and room for the user's own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include <QWidget>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;

namespace relievo {

// One target is chosen always, also while the search hides it.
class TargetList : public QWidget {
    Q_OBJECT
public:
    explicit TargetList(QWidget* parent = nullptr);
    const ExportRow& current() const { return *m_current; }
    QString currentName() const; // for setCurrent: the key; of the user's own "own/" and the key
    void setCurrent(const QString& name); // nothing changes where there is no such target
    void readOwn(); // again
    void add(const QString& file); // to the user's own, and chooses it; asks first where it would replace one

Q_SIGNALS:
    void chosen(); // another target
    void refused(const relievo::Error& why); // a file that was to be added

protected:
    void showEvent(QShowEvent*) override;
    bool eventFilter(QObject* watched, QEvent* event) override; // keys of the search field

private:
    struct Line {
        const ExportRow* row; // null: a heading, or a file that cannot be used
        QString text; // that is searched; "" of a heading
    };
    QWidget* ownBar();
    void fill();
    void addHeading(ExportGroup group);
    void addRow(const ExportRow& row);
    void addFault(const QString& file, const QString& fault);
    void filter(const QString& words);
    void lineChanged(int line);
    void takeFirst(); // of those that are seen, unless the current one is
    void take(const QString& file);
    int lineOf(const ExportRow& row) const; // -1: none
    void openFolder();
    QLineEdit* m_search;
    QListWidget* m_list;
    QLabel* m_none;
    const ExportRow* m_current = &kExports.front();
    std::vector<Line> m_lines; // of the list
};

} // namespace relievo
