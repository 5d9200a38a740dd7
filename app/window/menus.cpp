// From the action table to Qt's actions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/menus.h"
#include "app/window/viewport/navigation.h"
#include "app/window/viewport/samples_at_rest.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QAction>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>

namespace relievo {
namespace {
QString tip(const ActionRow& row)
{
    const QString keys = QKeySequence(qt(row.shortcut)).toString(QKeySequence::NativeText);
    return QString("<p><b>%1</b>%2<br>%3</p>")
        .arg(qt(row.label).remove("..."), keys.isEmpty() ? QString() : " &nbsp;" + keys, qt(row.help));
}

QDialog* plainDialog(QWidget* parent, const QString& title)
{
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    return dialog;
}

QLabel* dimLabel(const QString& text)
{
    auto* label = new QLabel(text);
    label->setProperty("role", "dim");
    return label;
}
} // namespace

namespace {
// By the settings; what the State decides follows it.
bool isOnAtStart(Action action)
{
    return action == Action::LightTheme ? savedLook() == Look::Light
        : action == Action::Smoother    ? SamplesAtRest().wanted() > SamplesAtRest::kUsual
                                        : false;
}
} // namespace

QMenu* menuOf(QMenuBar* bar, std::string_view title)
{
    for (QAction* action : bar->actions())
        if (action->menu() && action->menu()->title().remove('&') == qt(title))
            return action->menu();
    return nullptr;
}

Actions makeActions(QWidget* window, QMenuBar* bar, const std::function<void(Action, bool on)>& run)
{
    Actions actions;
    for (const ActionRow& row : kActions) {
        QMenu* menu = menuOf(bar, row.menu);
        if (!menu)
            menu = bar->addMenu('&' + qt(row.menu)); // Alt and its first letter open it
        if (row.startsGroup)
            menu->addSeparator();
        auto* action = new QAction(qt(row.label), window);
        action->setObjectName(qt(row.key));
        action->setShortcut(QKeySequence(qt(row.shortcut)));
        action->setCheckable(row.toggles);
        action->setChecked(isOnAtStart(row.action));
        action->setToolTip(tip(row));
        if (!row.icon.empty())
            action->setIcon(icon(row.icon));
        action->setIconVisibleInMenu(!row.toggles); // there the tick stands in its place
        QObject::connect(action, &QAction::triggered, window, [run, which = row.action](bool on) { run(which, on); });
        menu->addAction(action);
        actions.all[std::size_t(row.action)] = action;
    }
    return actions;
}

QToolButton* toolButton(QAction* action)
{
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setIconSize({16, 16});
    button->setFixedSize(28, 28);
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

QMenu* lazyMenu(QMenu* before, QAction* beforeAction, const QString& title, std::function<void(QMenu&)> fill)
{
    auto* menu = new QMenu(title, before);
    menu->setToolTipsVisible(true);
    before->insertMenu(beforeAction, menu);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, fill = std::move(fill)] {
        menu->clear();
        fill(*menu);
    });
    return menu;
}

void showShortcuts(QWidget* parent)
{
    QDialog* dialog = plainDialog(parent, QObject::tr("Mouse and keys"));
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(24, 16, 24, 24);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(6);
    int line[2] = {0, 0};
    const auto add = [&](int column, const QString& left, const QString& right, bool heading = false) {
        auto* label = heading ? new QLabel(left) : dimLabel(left);
        if (heading)
            label->setProperty("role", "heading");
        grid->addWidget(label, line[column], column * 2);
        grid->addWidget(new QLabel(right), line[column]++, column * 2 + 1);
    };
    add(0, QObject::tr("In the picture"), {}, true);
    for (const GestureRow& row : kGestures)
        add(0, qt(row.text), qt(row.does));
    add(0, QObject::tr("Shift or L, drag a handle"), QObject::tr("move that light"));
    add(0, QObject::tr("Wheel"), QObject::tr("move closer or away"));
    for (const CameraKeyRow& row : kCameraKeys)
        add(0, QKeySequence(row.key).toString(QKeySequence::NativeText), qt(row.does));
    add(0, QObject::tr("1, 2, 3 ... 9, 0, -"), QObject::tr("choose the view"));
    add(0, QObject::tr("Ctrl + 1, 2, 3 ..."), QObject::tr("choose the technique"));
    add(0, QObject::tr("In the panel"), {}, true);
    add(0, QObject::tr("Double click"), QObject::tr("back to the default"));
    add(0, QObject::tr("Ctrl + drag"), QObject::tr("fine"));
    add(0, QObject::tr("Shift + drag"), QObject::tr("coarse"));
    add(1, QObject::tr("Keys"), {}, true);
    for (const ActionRow& row : kActions)
        if (!row.shortcut.empty())
            add(1, QKeySequence(qt(row.shortcut)).toString(QKeySequence::NativeText), qt(row.label).remove("..."));
    add(1, "F10", QObject::tr("Open the menus"));
    auto* scroll = new QScrollArea; // on a small screen
    scroll->setWidgetResizable(true);
    scroll->setWidget(page);
    auto* layout = new QVBoxLayout(dialog);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    const QSize whole = page->sizeHint() + QSize(12, 2); // a scroll bar
    dialog->resize(whole.boundedTo(dialog->screen()->availableSize() - QSize(32, 64)));
    dialog->show();
}

void showAbout(QWidget* parent)
{
    QDialog* dialog = plainDialog(parent, QObject::tr("About Relievo"));
    auto* layout = new QVBoxLayout(dialog);
    layout->setContentsMargins(32, 24, 32, 24);
    layout->setSpacing(8);
    auto* name = new QLabel("Relievo " RELIEVO_VERSION);
    name->setProperty("role", "heading");
    layout->addWidget(name);
    layout->addWidget(new QLabel(QObject::tr("An editor for relief materials.")));
    layout->addWidget(dimLabel(QObject::tr("Copyright the Relievo authors. GNU General Public License, version 3 or later.\nThe shaders "
                                           "and all that is exported: MIT licence.")));
    dialog->show();
}

} // namespace relievo
