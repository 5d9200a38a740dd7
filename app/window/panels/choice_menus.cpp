// Filling menus of choices.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/choice_menus.h"
#include "app/window/widgets/text.h"
#include <QMenu>

namespace relievo {
namespace {
constexpr std::string_view kViewKeys = "1234567890-="; // of the first views, along the keyboard

// The keys of a row as a menu shows them. A shortcut of the item itself would make that of the window ambiguous.
template <typename Row>
void addChoice(QMenu& menu, const Row& row, const QKeySequence& keys, const std::string& current, std::function<void(const Row&)> chosen)
{
    const QString text = qt(row.label) + (keys.isEmpty() ? QString() : '\t' + keys.toString(QKeySequence::NativeText));
    QAction* action = menu.addAction(text);
    action->setObjectName(qt(row.key));
    action->setToolTip(qt(row.help));
    action->setCheckable(true);
    action->setChecked(row.key == current);
    QObject::connect(action, &QAction::triggered, &menu, [chosen = std::move(chosen), &row] { chosen(row); });
}
} // namespace

QVector<const TechniqueRow*> drawnTechniques(bool ofObjects)
{
    QVector<const TechniqueRow*> rows;
    const auto add = [&rows](const TechniqueRow& row) {
        if (!row.file.empty())
            rows.append(&row);
    };
    ofObjects ? (void)std::ranges::for_each(kObjectTechniques, add) : (void)std::ranges::for_each(kTechniques, add);
    return rows;
}

QKeySequence techniqueKeys(int index)
{
    return index < 9 ? QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + index)) : QKeySequence();
}

QKeySequence viewKeys(std::size_t index)
{
    return index < kViewKeys.size() ? QKeySequence(Qt::Key(kViewKeys[index]))
                                    : QKeySequence(); // Qt::Key_0 and its like are the characters' codes
}

void fillTechniques(QMenu& menu, const std::string& current, const std::function<void(const TechniqueRow&)>& chosen)
{
    menu.setToolTipsVisible(true);
    const TechniqueRow* ticked = findTechnique(current);
    const QVector<const TechniqueRow*> rows = drawnTechniques(ticked && ticked->isOfObjects);
    for (int i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i]->group() != rows[i - 1]->group()) {
            if (i > 0)
                menu.addSeparator();
            menu.addAction(qt(rows[i]->group()))->setEnabled(false); // a heading: sections of the style lose their texts to the style sheet
        }
        addChoice(menu, *rows[i], techniqueKeys(i), current, chosen);
    }
}

void fillViews(QMenu& menu, const std::string& current, const std::function<void(const ViewRow&)>& chosen)
{
    menu.setToolTipsVisible(true);
    for (std::size_t i = 0; i < kViews.size(); ++i)
        addChoice(menu, kViews[i], viewKeys(i), current, chosen);
}

} // namespace relievo
