// The command palette finds everything that the tables hold, and does it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"
#include "app/window/palette/command_palette.h"
#include "app/window/run_action.h"
#include "app/window/widgets/text.h"
#include "core/state/presets.h"
#include "tests/app/window_support.h"
#include <QLineEdit>
#include <QListWidget>
#include <cmath>
#include <numbers>

using namespace relievo;

namespace {
class PaletteTest : public WindowTest {
protected:
    CommandPalette& palette()
    {
        window.action("palette")->trigger();
        return *window.findChild<CommandPalette*>();
    }
    QLineEdit& line() { return *palette().findChild<QLineEdit*>("query"); }
    QString first(const QString& query)
    {
        const auto commands = commandsFor(query, window);
        return commands.empty() ? QString() : commands.front().title;
    }
    void type(const QString& query)
    {
        QLineEdit& query_line = line();
        query_line.setText(query);
        QTest::keyClick(&query_line, Qt::Key_Return);
    }
};
} // namespace

TEST_F(PaletteTest, FindsEveryRowByItsName)
{
    for (const ActionRow& row : kActions)
        if (row.action != Action::Palette) {
            EXPECT_FALSE(commandsFor(qt(row.label).remove("..."), window).empty()) << row.key;
        }
    for (const TechniqueRow* row : drawnTechniques())
        EXPECT_EQ(first("technique " + qt(row->key)).left(10), "Technique:") << row->key;
    for (const ViewRow& row : kViews)
        EXPECT_FALSE(commandsFor("view " + qt(row.key), window).empty()) << row.key;
    for (const ParameterRow& row : kParameters)
        EXPECT_FALSE(commandsFor(qt(row.key), window).empty()) << row.key;
    for (const PresetRow& row : kPresets)
        EXPECT_FALSE(commandsFor(qt(row.label), window).empty()) << row.key;
    EXPECT_TRUE(commandsFor("no such thing at all", window).empty());
}

TEST_F(PaletteTest, ChoosesAFieldOfViewThatKeepsTheSizeOfWhatIsSeen)
{
    Camera camera = cameraOf(state(), 0);
    camera.fov = 35.f, camera.distance = 2.f;
    window.document().edit({}, [&](State& edited) { edited.camera = camera; });
    type("field of view: 50");
    const Camera& wide = cameraOf(state(), 0);
    EXPECT_EQ(wide.fov, 50.f);
    EXPECT_NEAR(double(*wide.distance) * std::tan(25. * std::numbers::pi / 180.), 2. * std::tan(17.5 * std::numbers::pi / 180.), 1e-5);
    EXPECT_EQ(fieldOfViewText(50.f), QString::fromUtf8("50\u00b0 (26 mm)"));
}

TEST_F(PaletteTest, SetsAValueAsOneStepThatIsUndone)
{
    const int before = steps();
    const float depth = state().parameters.depth;
    EXPECT_EQ(first("depth 0.2"), "Set Depth to 0.2 tile");
    type("depth 0.2");
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.2f);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_FALSE(palette().findChild<QListWidget*>()->isHidden());
    palette().hide();
    window.action("undo")->trigger();
    EXPECT_FLOAT_EQ(state().parameters.depth, depth);
    type("silhouettes prisms");
    EXPECT_EQ(state().parameters.silhouettes, Silhouettes::Prisms);
    type("depth 99"); // out of range: nothing happens, and what is allowed is told
    EXPECT_FLOAT_EQ(state().parameters.depth, depth);
    const auto told = commandsFor("depth 99", window);
    ASSERT_FALSE(told.empty());
    EXPECT_FALSE(told.front().run);
    EXPECT_TRUE(told.front().detail.contains("1.5")) << told.front().detail.toStdString();
    palette().hide();
}

TEST_F(PaletteTest, IsDrivenByKeysAlone)
{
    CommandPalette& shown = palette();
    EXPECT_TRUE(shown.isVisible());
    auto& list = *shown.findChild<QListWidget*>("commands");
    auto& query = *shown.findChild<QLineEdit*>("query");
    QTest::keyClicks(&query, "technique");
    ASSERT_GT(list.count(), 5);
    EXPECT_EQ(list.currentRow(), 0);
    QTest::keyClick(&query, Qt::Key_Down);
    QTest::keyClick(&query, Qt::Key_Down);
    QTest::keyClick(&query, Qt::Key_Up);
    EXPECT_EQ(list.currentRow(), 1);
    query.setText("technique parallax occlusion");
    QTest::keyClick(&query, Qt::Key_Return);
    EXPECT_EQ(state().panes.front().technique, "pom");
    EXPECT_FALSE(shown.isVisible());
    window.action("palette")->trigger();
    query.setText("steepness"); // nothing
    QTest::keyClick(&query, Qt::Key_Return);
    EXPECT_TRUE(shown.isVisible());
    query.setText("fewest steps");
    QTest::keyClick(&query, Qt::Key_Return); // wants a value
    EXPECT_EQ(query.text(), "minSteps ");
    QTest::keyClick(&shown, Qt::Key_Escape);
    EXPECT_FALSE(shown.isVisible());
}
