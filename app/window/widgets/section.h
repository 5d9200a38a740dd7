// A heading over what belongs together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

class QAbstractButton;
class QVBoxLayout;

namespace relievo {

// A heading that opens and closes what stands under it; remembers it under its title between sessions.
class Section : public QWidget {
    Q_OBJECT
public:
    explicit Section(const QString& title, QWidget* parent = nullptr, bool isOpenAtFirst = true);
    QVBoxLayout* body() const { return m_body; }
    QWidget* header() const;
    bool isOpen() const { return m_open; }
    void setOpen(bool open);

Q_SIGNALS:
    void opened(bool open);

private:
    QString m_title;
    QAbstractButton* m_header;
    QWidget* m_content;
    QVBoxLayout* m_body;
    bool m_open = true;
};

} // namespace relievo
