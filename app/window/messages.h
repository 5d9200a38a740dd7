// What the user should know now, by the part of the program that says it; a part that has nothing more to say falls silent.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include <QList>
#include <QMap>
#include <QObject>
#include <QString>

namespace relievo {

struct Message {
    bool isError = false; // else a warning: the work went on
    QString text; // one sentence
    bool operator==(const Message&) const = default;
};

class Messages : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    // Replaces everything that `source` said before; nothing to say withdraws it.
    void set(const QString& source, const QList<Message>& messages);
    void set(const QString& source, const Warnings& warnings);
    void set(const QString& source, const Error& error);
    void clear(const QString& source) { set(source, QList<Message>{}); }

    QList<Message> all() const; // errors first

Q_SIGNALS:
    void changed();

private:
    QMap<QString, QList<Message>> m_bySource;
};

} // namespace relievo
