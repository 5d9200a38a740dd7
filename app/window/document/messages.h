// What the user should know now, by the part of the program that says it; a part that has nothing more to say falls silent.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <utility>

namespace relievo {

// What the user may do about a message, by a button beside it.
struct Offer {
    QString label;
    std::function<void()> take;
    bool operator==(const Offer& other) const { return label == other.label; }
};

struct Message {
    bool isError = false; // else a warning, unless it is one of the below: the work went on
    QString text; // one sentence
    bool isNotice = false; // neither: how the work goes on; shown in the line alone, so that its coming and going moves nothing
    bool isNote = false; // neither: what was recognised and is as it should be; counts as no warning
    QList<Offer> choices = {};
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
    void setNotice(const QString& source, const QString& text) { set(source, QList<Message>{{false, text, true}}); }
    void clear(const QString& source) { set(source, QList<Message>{}); }

    QList<Message> all() const; // errors first, then warnings, notes, notices; among equals those of the part that spoke last

Q_SIGNALS:
    void changed();

private:
    QList<std::pair<QString, QList<Message>>> m_bySource; // newest first
};

} // namespace relievo
