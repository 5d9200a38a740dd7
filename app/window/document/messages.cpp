// The list behind the message line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/messages.h"
#include "core/ground/shown_text.h"
#include <QRegularExpression>
#include <algorithm>
#include <string_view>

namespace relievo {
namespace {
// Warnings of core that tell of what was recognised and put right.
constexpr std::string_view kGoodNews[] = {"relief-json", "normal-directx", "depth-map"};

// As it stands in the window: core's texts may name an option of the command line, before its value or in brackets, "(--height FILE)".
QString inTheWindow(const std::string& text)
{
    static const QRegularExpression option(R"(\s*\(--[a-z][^)]*\)|--[a-z]+ )");
    return QString::fromStdString(shownText(text)).remove(option);
}

int rankOf(const Message& message)
{
    return message.isError ? 0 : message.isNotice ? 3 : message.isNote ? 2 : 1;
}
} // namespace

void Messages::set(const QString& source, const QList<Message>& messages)
{
    const auto there = std::ranges::find(m_bySource, source, &std::pair<QString, QList<Message>>::first);
    const bool asks = std::ranges::any_of(messages, [](const Message& one) { return !one.choices.isEmpty(); }); // of this moment
    if (there == m_bySource.end() ? messages.isEmpty() : there->second == messages && !asks)
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
        messages.append({.text = inTheWindow(warning.text), .isNote = std::ranges::count(kGoodNews, std::string_view(warning.code)) > 0});
    set(source, messages);
}

void Messages::set(const QString& source, const Error& error)
{
    set(source, QList<Message>{{true, inTheWindow(message(error))}});
}

QList<Message> Messages::all() const
{
    QList<Message> list;
    for (const auto& [source, messages] : m_bySource)
        for (const Message& one : messages)
            if (!list.contains(one))
                list.append(one);
    std::ranges::stable_sort(list, {}, rankOf);
    return list;
}

} // namespace relievo
