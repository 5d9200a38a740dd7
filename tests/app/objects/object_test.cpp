// Relief objects in the window: baking them, opening what was baked, and their techniques.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/measuring_run.h"
#include "app/window/objects/impostor_dialog.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/widgets/segmented.h"
#include "tests/app/window_support.h"
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

using namespace relievo;

namespace {
constexpr int kBaking = 120000; // ms

class ObjectTest : public WindowTest {
protected:
    ImpostorDialog* asked()
    {
        window.action("impostor")->trigger();
        QCoreApplication::processEvents();
        return window.findChild<ImpostorDialog*>();
    }
    void setMesh(const std::string& mesh)
    {
        window.assets().propose("Mesh", [mesh](State& state) { state.mesh = mesh; });
        settle();
    }
    const std::string& technique() { return window.document().state().panes.front().technique; }
    QStringList listed()
    {
        QMenu menu;
        fillTechniques(menu, technique(), [](const TechniqueRow&) {});
        QStringList keys;
        for (const QAction* action : menu.actions())
            keys << action->objectName();
        return keys;
    }
};
} // namespace

TEST_F(ObjectTest, AMeshIsBakedAndShown)
{
    setMesh("torus");
    ImpostorDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    auto* line = dialog->findChild<QLineEdit*>("folder");
    EXPECT_EQ(line->text(), ""); // built-in shapes lie nowhere
    const QString out = file("torus");
    line->setText(out);
    for (const auto& [key, index] : {std::pair("sides", 1), std::pair("layers", 0), std::pair("size", 0), std::pair("supersample", 0)}) {
        auto* buttons = dialog->findChild<Segmented*>(key);
        QTest::mouseClick(buttons, Qt::LeftButton, {}, buttons->segment(index).center());
    }
    EXPECT_EQ(dialog->options(), QStringList({"--sides", "2", "--layers", "1", "--size", "128", "--supersample", "1"}));
    dialog->accept();
    MeasuringRun& run = measuringOf(window);
    EXPECT_TRUE(run.busy());
    ASSERT_TRUE(waitFor([&] { return !run.busy(); }, kBaking));
    ASSERT_TRUE(QDir(out).exists("Torus.object.json")) << window.messageLine().text().toStdString();
    bool offered = false;
    for (const Message& told : window.messages().all())
        if (told.text.startsWith("Relief object written") && !told.choices.isEmpty()) {
            window.document().start(window.document().state(), {}); // nothing unsaved: no question
            told.choices.front().take();
            offered = true;
            break;
        }
    ASSERT_TRUE(offered);
    settle();
    EXPECT_TRUE(isObjectName(window.document().state().mesh));
    EXPECT_EQ(technique(), "object");
    EXPECT_TRUE(window.assets().resources().mesh->object);
    EXPECT_TRUE(listed().contains("object-sides"));
    EXPECT_FALSE(listed().contains("relief"));
    ASSERT_TRUE(waitFor([&] { return window.viewport().isFull(); }));

    // An object is not baked again; a mesh brings the techniques of meshes back, and undo the object's.
    dialog = asked();
    EXPECT_EQ(dialog, nullptr);
    EXPECT_TRUE(window.messageLine().text().contains("relief object already")) << window.messageLine().text().toStdString();
    setMesh("sphere");
    EXPECT_EQ(technique(), "relief");
    EXPECT_TRUE(listed().contains("relief"));
    EXPECT_FALSE(listed().contains("object"));
    window.document().undoStack().undo();
    settle();
    EXPECT_EQ(technique(), "object");
}

TEST_F(ObjectTest, WithoutAFolderNothingIsBaked)
{
    setMesh("torus");
    ImpostorDialog* dialog = asked();
    ASSERT_NE(dialog, nullptr);
    QPushButton* bake = nullptr;
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
        if (button->text().remove('&') == "Bake")
            bake = button;
    ASSERT_NE(bake, nullptr);
    EXPECT_FALSE(bake->isEnabled());
    dialog->findChild<QLineEdit*>("folder")->setText(file("x"));
    EXPECT_TRUE(bake->isEnabled());
    dialog->reject();
    EXPECT_FALSE(measuringOf(window).busy());
}
