// The list behind the message line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/messages.h"
#include <algorithm>

namespace relievo {

void Messages::set(const QString& source, const QList<Message>& messages)
{
    if (m_bySource.value(source) == messages)
        return;
    if (messages.isEmpty())
        m_bySource.remove(source);
    else
        m_bySource[source] = messages;
    Q_EMIT changed();
}

void Messages::set(const QString& source, const Warnings& warnings)
{
    QList<Message> messages;
    for (const Warning& warning : warnings)
        messages.append({false, QString::fromStdString(warning.text)});
    set(source, messages);
}

void Messages::set(const QString& source, const Error& error)
{
    set(source, QList<Message>{{true, QString::fromStdString(message(error))}});
}

QList<Message> Messages::all() const
{
    QList<Message> list;
    for (const QList<Message>& messages : m_bySource)
        for (const Message& one : messages)
            if (!list.contains(one))
                list.append(one);
    std::stable_partition(list.begin(), list.end(), [](const Message& one) { return one.isError; });
    return list;
}

} // namespace relievo
