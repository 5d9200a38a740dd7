// The list of targets: groups, search, keys, what is remembered, and the switches that go with a target.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/target_list.h"
#include "app/window/widgets/switch.h"
#include "app/window/widgets/text.h"
#include "core/exporters/engines/target_text.h"
#include "tests/app/export_support.h"
#include <QListWidget>
#include <QPushButton>

using namespace relievo;

namespace {
class TargetListTest : public ExportingTest {
protected:
    TargetList& targets() { return *window.findChild<TargetList*>(); }
    QListWidget& list() { return *targets().findChild<QListWidget*>("targets"); }
    QLineEdit& search() { return *targets().findChild<QLineEdit*>("search"); }
    QStringList seen() // headings too
    {
        QStringList labels;
        for (int line = 0; line < list().count(); ++line)
            if (!list().item(line)->isHidden())
                labels << list().item(line)->text();
        return labels;
    }
    void look(const char* words)
    {
        search().setFocus();
        search().clear();
        QTest::keyClicks(&search(), words);
    }
    Switch& cure(const char* word) { return *window.findChild<Switch*>(QString("cure-") + word); }
};
} // namespace

TEST_F(TargetListTest, EachTargetStandsInAGroupWithIconAndSentence)
{
    exportTo("gltf");
    int rows = 0;
    for (int line = 0; line < list().count(); ++line) {
        const QListWidgetItem& item = *list().item(line);
        if (!(item.flags() & Qt::ItemIsSelectable))
            continue;
        ++rows;
        EXPECT_FALSE(item.icon().pixmap(20, 20).isNull());
        EXPECT_FALSE(item.data(Qt::UserRole).toString().isEmpty()) << item.text().toStdString();
    }
    EXPECT_EQ(rows, int(kExports.size()));
    const QStringList all = seen();
    EXPECT_LT(all.indexOf("Engines and programs"), all.indexOf("Godot 4"));
    EXPECT_LT(all.indexOf("Godot 4"), all.indexOf("Formats"));
    EXPECT_LT(all.indexOf("Formats"), all.indexOf("glTF"));
    EXPECT_LT(all.indexOf("Shader text"), all.indexOf("GLSL"));
    EXPECT_LT(all.indexOf("Relievo"), all.indexOf("Relievo preset"));
    for (const ExportRow& row : kExports)
        EXPECT_TRUE(QFile::exists(":/resources/icons/" + qt(row.icon) + ".svg")) << row.key;
}

TEST_F(TargetListTest, TheSearchLooksIntoLabelKeyAndHelp)
{
    exportTo("gltf");
    look("unity high");
    EXPECT_EQ(seen(), (QStringList{"Engines and programs", "Unity, high definition pipeline"}));
    look("urp");
    EXPECT_EQ(seen(), (QStringList{"Engines and programs", "Unity, universal pipeline"})) << "by its key";
    look("UsdPreviewSurface");
    EXPECT_EQ(seen(), (QStringList{"Formats", "USD"})) << "by its help";
    EXPECT_EQ(targets().current().key, "gltf") << "looking chooses nothing";
    look("no such thing");
    EXPECT_TRUE(seen().isEmpty());
    EXPECT_FALSE(list().isVisible());
    search().clear();
    EXPECT_GT(seen().size(), qsizetype(kExports.size()));
}

TEST_F(TargetListTest, KeysChoose)
{
    ExportDialog& dialog = exportTo("gltf");
    look("unity");
    QTest::keyClick(&search(), Qt::Key_Down);
    EXPECT_EQ(targets().current().key, "unity-builtin") << "the first that is seen";
    QTest::keyClick(&search(), Qt::Key_Down);
    EXPECT_EQ(targets().current().key, "unity-urp");
    EXPECT_EQ(dialog.findChild<QLabel*>("target")->text(), "Unity, universal pipeline");
    look("godot");
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(targets().current().key, "godot4");
    EXPECT_EQ(dialog.focusWidget(), &list());
    EXPECT_FALSE(dialog.busy()) << "Enter in the search field exports nothing";
    search().clear();
    QTest::keyClick(&list(), Qt::Key_Down);
    QTest::keyClick(&list(), Qt::Key_Down);
    EXPECT_EQ(targets().current().key, "unity-builtin") << "of all again: Godot 3 and then this one";
    dialog.setOut(file("by_key"));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_TRUE(dialog.busy()) << "Enter in the list exports";
    finish(dialog);
}

TEST_F(TargetListTest, TheTargetIsRememberedForTheNextTime)
{
    exportTo("three").close();
    MainWindow other;
    ExportDialog dialog(other.document(), other.assets());
    EXPECT_EQ(dialog.findChild<TargetList*>()->current().key, "three");
    EXPECT_EQ(dialog.findChild<QLabel*>("target")->text(), "three.js");
}

TEST_F(TargetListTest, CuresAreSwitchesWithTheirReason)
{
    ExportDialog& dialog = exportTo("o3de");
    for (std::size_t i = 0; i < kChoices<Cure>; ++i) {
        Switch& one = cure(std::string(wordOf(Cure(i))).c_str());
        EXPECT_EQ(one.isChecked(), kCures[Cure(i)].byDefault) << wordOf(Cure(i));
        EXPECT_TRUE(one.toolTip().contains(qt(kCures[Cure(i)].help).left(40)));
    }
    EXPECT_TRUE(cure("normals").isEnabled() && cure("full-range").isEnabled());
    EXPECT_FALSE(cure("dither").isEnabled()) << "its height has 16 bits";
    EXPECT_FALSE(cure("bump").isEnabled()) << "for glTF alone";
    dialog.setTarget("gltf");
    EXPECT_TRUE(cure("bump").isEnabled());
    dialog.setTarget("bevy");
    EXPECT_TRUE(cure("dither").isEnabled());
    dialog.setTarget("preset");
    EXPECT_FALSE(cure("normals").isEnabled() || cure("full-range").isEnabled() || cure("dither").isEnabled());
}

TEST_F(TargetListTest, ACureThatIsOffIsLeftOutAndStaysOff)
{
    window.document().edit("Maps", [](State& s) { s.slots[std::size_t(MapKind::Normal)] = {}; });
    settle();
    ASSERT_EQ(window.assets().resources().material->map(MapKind::Normal), nullptr);
    ExportDialog& dialog = exportTo("godot4");
    const auto normals = [&](const char* name) {
        dialog.setOut(file(name));
        dialog.run();
        finish(dialog);
        return !QDir(file(name)).entryList({"*_normal*.png"}).isEmpty();
    };
    EXPECT_TRUE(normals("with")) << result(dialog).text().toStdString();
    QTest::mouseClick(&cure("normals"), Qt::LeftButton);
    EXPECT_TRUE(result(dialog).isHidden()) << "what was told was of another choice";
    EXPECT_FALSE(normals("without")) << result(dialog).text().toStdString();
    MainWindow other;
    ExportDialog next(other.document(), other.assets());
    EXPECT_FALSE(next.findChild<Switch*>("cure-normals")->isChecked());
    EXPECT_TRUE(next.findChild<Switch*>("cure-dither")->isChecked());
}

TEST_F(TargetListTest, ACureThatIsOffByDefaultIsDoneWhenTurnedOn)
{
    ExportDialog& dialog = exportTo("gltf");
    const auto namesBump = [&](const char* name) {
        dialog.setOut(file(name));
        dialog.run();
        finish(dialog);
        QFile written(file(name));
        return written.open(QIODevice::ReadOnly) && written.readAll().contains("EXT_materials_bump");
    };
    EXPECT_FALSE(namesBump("without.glb")) << result(dialog).text().toStdString();
    QTest::mouseClick(&cure("bump"), Qt::LeftButton);
    EXPECT_TRUE(namesBump("with.glb")) << result(dialog).text().toStdString();
    QTest::mouseClick(&cure("bump"), Qt::LeftButton); // the settings keep it
}

TEST_F(TargetListTest, TheDialogFitsASmallScreenAndNothingMovesWhenATargetIsChosen)
{
    ExportDialog& dialog = exportTo("gltf");
    dialog.resize(768, 536); // what 800 x 600 leaves
    EXPECT_EQ(dialog.size(), QSize(768, 536));
    QTest::qWait(50);
    const auto places = [&] {
        QList<QRect> all;
        for (const char* name : {"search", "targets", "out", "packing", "cure-dither", "our-picture", "drawing", "files", "run"})
            all << dialog.findChild<QWidget*>(name)->geometry();
        return all;
    };
    const QList<QRect> before = places();
    for (const ExportRow& row : kExports) {
        dialog.setTarget(row.key);
        QTest::qWait(10);
        EXPECT_EQ(places(), before) << row.key;
    }
}

// Of the table: what a switch is there for changes what is written.
TEST(Cures, TheyAreUsedByTheTargetsThatHoldWhatTheyCure)
{
    for (const ExportRow& row : kExports) {
        const EnumSet<Cure> used = curesUsedBy(row);
        EXPECT_EQ(used.contains(Cure::Bump), row.key == "gltf") << row.key;
        if (row.code) {
            EXPECT_FALSE(used.contains(Cure::FullRange) || used.contains(Cure::Normals) || used.contains(Cure::Dither)) << row.key;
        } else if (row.engine.bits == 8) {
            EXPECT_TRUE(used.contains(Cure::Dither)) << row.key;
        }
    }
    const auto packing = parseTarget(R"({"textures": [{"key": "a", "file": "a.png", "channels": ["roughness"]}]})", "a.json", false);
    EXPECT_TRUE(curesUsedBy(*findExport("bevy"), &*packing).empty());
}
