// The list behind the message line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/messages.h"
#include "core/ground/shown_text.h"
#include <algorithm>

namespace relievo {

void Messages::set(const QString& source, const QList<Message>& messages)
{
    const auto there = std::ranges::find(m_bySource, source, &std::pair<QString, QList<Message>>::first);
    if (there == m_bySource.end() ? messages.isEmpty() : there->second == messages)
        return;
    if (there != m_bySource.end())
        m_bySource.erase(there);
    if (!messages.isEmpty())
        m_bySource.prepend({source, messages});
    Q_EMIT changed();
}

void Messages::set(const QString& source, const Warnings& warnings)
{
    QList<Message> messages;
    for (const Warning& warning : warnings)
        messages.append({false, QString::fromStdString(shownText(warning.text))});
    set(source, messages);
}

void Messages::set(const QString& source, const Error& error)
{
    set(source, QList<Message>{{true, QString::fromStdString(message(error))}});
}

QList<Message> Messages::all() const
{
    QList<Message> list;
    for (const auto& [source, messages] : m_bySource)
        for (const Message& one : messages)
            if (!list.contains(one))
                list.append(one);
    std::ranges::stable_sort(list, {}, [](const Message& one) { return one.isError ? 0 : one.isNotice ? 2 : 1; });
    return list;
}

} // namespace relievo
