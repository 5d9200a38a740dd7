// Commands from the tables of actions, techniques, views, presets, samples and parameters.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/commands.h"
#include "app/actions.h"
#include "app/window/document/editing.h"
#include "app/window/document/files.h"
#include "app/window/main_window.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/run_action.h"
#include "app/window/viewport/navigation.h"
#include "app/window/widgets/text.h"
#include "core/image/samples/samples.h"
#include "core/state/presets.h"
#include <QAction>
#include <QRegularExpression>
#include <algorithm>

namespace relievo {
namespace {
QStringList wordsOf(const QString& text)
{
    return text.toLower().split(QRegularExpression("[\\s:]+"), Qt::SkipEmptyParts);
}

bool fits(const QStringList& query, const Command& command)
{
    const QString all = (command.title + ' ' + command.words).toLower();
    return std::ranges::all_of(query, [&](const QString& word) { return all.contains(word); });
}

// 0 best: the title begins so, then one of its words, then the rest.
int distance(const QStringList& query, const Command& command)
{
    if (query.isEmpty())
        return 0;
    const QStringList words = wordsOf(command.title);
    const auto begins = [&](const QString& word) { return word.startsWith(query.front()); };
    return !words.isEmpty() && begins(words.front()) ? 0 : std::ranges::any_of(words, begins) ? 1 : 2;
}

void addActions(std::vector<Command>& commands, MainWindow& window)
{
    for (const ActionRow& row : kActions) {
        if (row.action == Action::Palette)
            continue;
        QAction* action = window.action(row.key);
        commands.push_back({qt(row.label).remove("..."), action->shortcut().toString(QKeySequence::NativeText),
            qt(row.menu) + ' ' + qt(row.help), action->isEnabled() ? std::function<void()>([action] { action->trigger(); }) : nullptr});
    }
}

void addChoices(std::vector<Command>& commands, MainWindow& window)
{
    for (const TechniqueRow* row : drawnTechniques(isObjectName(window.document().state().mesh)))
        commands.push_back({QObject::tr("Technique: %1").arg(qt(row->label)), qt(row->group()), qt(row->key),
            [&window, row] { window.setTechnique(row->key); }});
    for (const ViewRow& row : kViews)
        commands.push_back({QObject::tr("View: %1").arg(qt(row.label)), {}, qt(row.key), [&window, &row] { window.setView(row.key); }});
    for (const float degrees : kFieldsOfView)
        commands.push_back({QObject::tr("Field of view: %1").arg(fieldOfViewText(degrees)), {}, QObject::tr("camera lens focal length"),
            [&window, degrees] { setFieldOfView(window, degrees); }});
    for (const PresetRow& row : kPresets) {
        const bool isScene = !row.sample.empty();
        commands.push_back({(isScene ? QObject::tr("Scene: %1") : QObject::tr("Preset: %1")).arg(qt(row.label)), {}, qt(row.help),
            [&window, &row, isScene] {
                isScene ? window.files().open("scene:" + qt(row.key)) : window.files().applyPreset(std::string(row.key));
            }});
    }
    for (const SampleRow& row : kSamples)
        commands.push_back({QObject::tr("Sample: %1").arg(qt(row.label)), {}, qt(row.help),
            [&window, key = row.key] { window.assets().openInto("sample:" + qt(key)); }});
}

QString shownValue(const ParameterRow& row, const Value& value)
{
    return qt(toText(row, value)) + (row.unit.empty() ? QString() : ' ' + qt(row.unit));
}

// With the last word as the value where there are several, else as something that wants one.
void addParameters(std::vector<Command>& commands, const QString& query, MainWindow& window)
{
    const State& state = window.document().state();
    for (const ParameterRow& row : kParameters) {
        Command command{QObject::tr("%1: %2").arg(qt(wordOf(row.group)), qt(row.label)), shownValue(row, get(state.parameters, row)),
            qt(row.key) + ' ' + qt(row.help), nullptr, qt(row.key) + ' '};
        const QStringList words = wordsOf(query);
        const bool named = words.size() > 1 && fits(words.mid(0, words.size() - 1), {command.title, {}, qt(row.key), nullptr})
            && !fits(words, {command.title, {}, qt(row.key), nullptr}); // else the last word belongs to the name
        if (!named) {
            commands.push_back(std::move(command));
            continue;
        }
        State set = state;
        const auto done = setParameter(set, std::string(row.key) + '=' + words.back().toStdString());
        if (!done) { // what is allowed
            command.detail = QString::fromStdString(done.error().hint);
        } else {
            const Value value = get(set.parameters, row);
            command.title = QObject::tr("Set %1 to %2").arg(qt(row.label), shownValue(row, value));
            command.isMeant = true;
            command.run = [&window, &row, value] {
                window.document().edit(qt(row.label), [&](State& changed) { assign(changed, row, value, kAllPanes); });
            };
        }
        command.words += ' ' + words.back();
        command.completion.clear();
        commands.push_back(std::move(command));
    }
}
} // namespace

std::vector<Command> commandsFor(const QString& query, MainWindow& window)
{
    std::vector<Command> commands;
    addActions(commands, window);
    addChoices(commands, window);
    addParameters(commands, query, window);
    const QStringList words = wordsOf(query);
    std::erase_if(commands, [&](const Command& command) { return !fits(words, command); });
    std::ranges::stable_sort(commands, {}, [&](const Command& command) { return std::pair(!command.isMeant, distance(words, command)); });
    return commands;
}

} // namespace relievo
