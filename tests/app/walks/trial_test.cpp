// What an artist's trial found: the wheel over lists, numbers that do not fit, typed units, menus by keys, narrow windows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/choice_menus.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/section.h"
#include "app/window/widgets/slider_scale.h"
#include "core/state/views.h"
#include "tests/app/window_support.h"
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QToolTip>

using namespace relievo;

namespace {
class TrialTest : public WindowTest {
protected:
    NumberField& field(const char* key) { return *editor(key).findChild<NumberField*>(); }
    void type(const char* key, const char* text)
    {
        field(key).setFocus();
        field(key).selectAll();
        QTest::keyClicks(&field(key), QString::fromUtf8(text));
        QTest::keyClick(&field(key), Qt::Key_Return);
    }
    static bool wheel(QWidget& widget, int notches)
    {
        const QPointF at = QRectF(widget.rect()).center();
        QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&widget, &event);
        return event.isAccepted();
    }
    QMenu& menu(const char* title)
    {
        for (QAction* action : window.menuWidget()->findChild<QMenuBar*>("menu")->actions())
            if (action->text() == title)
                return *action->menu();
        ADD_FAILURE() << title;
        return *new QMenu;
    }
};
} // namespace

TEST_F(TrialTest, TheWheelOverAListScrollsThePanelAndChangesNothing)
{
    drop(mapRow("roughness"), writeImage("shine.png", 8));
    settle();
    window.document().start(state(), {});
    window.resize(1000, 500);
    QTest::qWait(20);
    const State before = state();
    int lists = 0;
    for (QComboBox* list : window.findChildren<QComboBox*>()) {
        ++lists;
        list->setFocus();
        for (int notches : {-1, 1})
            EXPECT_FALSE(wheel(*list, notches)) << "else the system does not pass it on to the panel";
        EXPECT_TRUE(state() == before) << list->parentWidget()->objectName().toStdString() << list->currentText().toStdString();
    }
    EXPECT_GE(lists, 12);
    EXPECT_EQ(steps(), 0);
}

TEST_F(TrialTest, EveryNumberFitsItsField)
{
    for (const ParameterRow& row : kParameters) {
        const auto* field
            = window.parameters().findChild<ParameterEditor*>(QString::fromStdString(std::string(row.key)))->findChild<NumberField*>();
        if (!field)
            continue;
        const int room = field->width() - 2 * 3 - 2 - 4; // padding, border, and what a line edit leaves free at its ends
        for (double share : {0., 0.00001, 0.0001234, 0.01234, 0.1234, 0.98765, 1.})
            for (double end : {double(row.min), double(row.max)}) {
                const QString text = numberText(row, end * share);
                EXPECT_LE(field->fontMetrics().horizontalAdvance(text), room) << row.key << ' ' << text.toStdString();
                EXPECT_FALSE(text.contains('e')) << text.toStdString();
            }
    }
}

TEST_F(TrialTest, EveryNameFitsItsLine)
{
    window.parameters().setFixedWidth(window.parameters().minimumWidth());
    auto* scroll = window.parameters().findChild<QScrollArea*>();
    QTest::qWait(20);
    EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width());
    for (const ParameterRow& row : kParameters) {
        const auto* label
            = window.parameters().findChild<ParameterEditor*>(QString::fromStdString(std::string(row.key)))->findChild<QLabel*>();
        EXPECT_GE(label->width(), label->sizeHint().width()) << row.key;
    }
}

TEST(Numbers, HaveFourDigitsThatCount)
{
    const auto text = [](const char* key, double value) { return numberText(*findParameter(key), value).toStdString(); };
    EXPECT_EQ(text("tiling", 1000), "1000");
    EXPECT_EQ(text("tiling", 123.456), "123.5");
    EXPECT_EQ(text("tiling", 2), "2.00");
    EXPECT_EQ(text("fetchRange", 1000), "1000");
    EXPECT_EQ(text("depth", double(0.0004f)), "0.0004");
    EXPECT_EQ(text("depth", double(0.0125f)), "0.0125");
    EXPECT_EQ(text("metresPerUV", double(0.004f)), "0.004");
    EXPECT_EQ(text("metresPerUV", 0), "auto");
    EXPECT_EQ(plainNumber(1000).toStdString(), "1000");
    EXPECT_EQ(plainNumber(0.000025).toStdString(), "0.000025");
    EXPECT_EQ(plainNumber(0).toStdString(), "0");
    EXPECT_EQ(plainNumber(double(0.05f) / 4).toStdString(), "0.0125");
    EXPECT_EQ(plainNumber(10).toStdString(), "10");
}

TEST_F(TrialTest, ADoubleClickOnASliderIsOneStep)
{
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    Slider& depth = slider("depth");
    const QPoint away(depth.width() - 8, depth.height() / 2);
    const auto doubleClick = [&] { // as the system sends it
        QTest::mouseClick(&depth, Qt::LeftButton, Qt::NoModifier, away);
        QTest::mouseDClick(&depth, Qt::LeftButton, Qt::NoModifier, away);
    };
    doubleClick();
    EXPECT_EQ(state().parameters.depth, Parameters{}.depth);
    EXPECT_FALSE(window.document().inGesture());
    EXPECT_EQ(steps(), 2);
    window.action("undo")->trigger();
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.3f);
    window.document().start(State{state()}, {});
    QTest::mouseClick(&depth, Qt::LeftButton, Qt::NoModifier, away);
    QTest::keyClick(&depth, Qt::Key_Delete);
    EXPECT_EQ(steps(), 2) << "a click, and later a reset";
}

TEST_F(TrialTest, UnitsMayBeTyped)
{
    for (const char* text : {"45 deg", "45\u00b0", "45 \u00b0", "45DEG", "45,0"}) {
        type("rotation", "10");
        type("rotation", text);
        EXPECT_FLOAT_EQ(state().parameters.rotation, 45.f) << text;
    }
    type("depth", "5 %");
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.05f);
    type("depth", "0.2 tile");
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.2f);
    type("metresPerUV", "3 m");
    EXPECT_FLOAT_EQ(state().parameters.metresPerUV, 3.f);
    type("metresPerUV", "auto");
    EXPECT_EQ(state().parameters.metresPerUV, 0.f);
}

TEST_F(TrialTest, WhatIsRefusedOrLimitedIsSaid)
{
    for (const char* text : {"7", "deep", "5 furlongs"}) {
        QToolTip::hideText();
        type("depth", "0.2");
        type("depth", text);
        EXPECT_TRUE(waitFor([] { return QToolTip::text() == "0 to 1.5 tile"; }, 2000)) << text << QToolTip::text().toStdString();
    }
}

TEST_F(TrialTest, MenusOpenByKeys)
{
    QTest::keyClick(&window, Qt::Key_F, Qt::AltModifier);
    EXPECT_TRUE(menu("&File").isVisible());
    menu("&File").close();
    QTest::keyClick(&window, Qt::Key_V, Qt::AltModifier);
    EXPECT_TRUE(menu("&View").isVisible());
    menu("&View").close();
    QTest::keyClick(&window, Qt::Key_F10);
    EXPECT_TRUE(menu("&File").isVisible());
    menu("&File").close();
}

TEST_F(TrialTest, TheFirstTwelveViewsHaveAKey)
{
    QTest::keyClick(&window, Qt::Key_0);
    EXPECT_EQ(state().panes.front().view, "error");
    QTest::keyClick(&window, Qt::Key_Minus);
    EXPECT_EQ(state().panes.front().view, "overshoot");
    QTest::keyClick(&window, Qt::Key_Equal);
    EXPECT_EQ(state().panes.front().view, "error-mesh");
}

TEST_F(TrialTest, TabGoesThroughOneSectionAfterTheOther)
{
    QVector<QWidget*> reached;
    auto* headers = window.parameters().findChild<Section*>()->header();
    for (QWidget* next = headers; !reached.contains(next) && window.parameters().isAncestorOf(next); next = next->nextInFocusChain())
        if (next->focusPolicy() & Qt::TabFocus)
            reached.append(next);
    const auto at = [&](QWidget* widget) { return reached.indexOf(widget); };
    ASSERT_GE(at(&slider("depth")), 0);
    qsizetype last = -1;
    for (Section* section : window.parameters().findChildren<Section*>()) {
        EXPECT_GT(at(section->header()), last);
        last = at(section->header());
        for (ParameterEditor* line : section->findChildren<ParameterEditor*>())
            for (QWidget* control : line->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
                if (control->focusPolicy() & Qt::TabFocus) {
                    EXPECT_EQ(at(control), last + 1) << line->objectName().toStdString();
                    last = at(control);
                }
    }
}

TEST_F(TrialTest, CaptionsStayInTheirPanes)
{
    window.action("two-panes")->trigger();
    window.setTechnique("relief-fixed");
    window.resize(900, 600);
    Viewport& picture = window.viewport();
    ASSERT_TRUE(waitFor([&] { return picture.isSettled(); }));
    QTest::qWait(300); // costs are measured when the picture rests
    for (int width : {900, 700, 400, 220, 120}) {
        picture.setFixedWidth(width);
        QTest::qWait(30);
        const auto captions = picture.findChildren<PaneCaption*>();
        ASSERT_EQ(captions.size(), 2);
        EXPECT_LT(captions[0]->geometry().right(), picture.width() / 2) << width;
        EXPECT_LT(captions[1]->geometry().right(), picture.width()) << width;
    }
    PaneCaption caption(&picture);
    caption.show("A", "Relief 8-32", "Shaded", "12.3 fetches/px", true);
    caption.fit(1000);
    const int full = caption.width();
    caption.fit(full - 1);
    EXPECT_LT(caption.width(), full - 40) << "without the cost at once";
}

TEST_F(TrialTest, TheSecondPaneComesBackAsItWas)
{
    window.action("two-panes")->trigger();
    window.document().edit("B", [](State& s) { s.panes[1].technique = "bump", s.panes[1].overrides["depth"] = 0.3f; });
    const Pane second = state().panes[1];
    window.action("two-panes")->trigger();
    ASSERT_EQ(state().panes.size(), 1u);
    window.action("two-panes")->trigger();
    ASSERT_EQ(state().panes.size(), 2u);
    EXPECT_TRUE(state().panes[1] == second);
    EXPECT_EQ(window.document().undoStack().undoText(), window.action("two-panes")->text());
    window.document().start(State{}, {});
    window.action("two-panes")->trigger();
    EXPECT_FALSE(state().panes[1] == second) << "another document";
}

TEST_F(TrialTest, LegendsSayWhatTheNumbersAre)
{
    auto* legend = window.viewport().findChild<HeatLegend*>();
    window.setView("depth");
    EXPECT_EQ(legend->caption(), "Depth (share of the depth)");
    window.setView("fetches");
    EXPECT_EQ(legend->caption(), "Fetches a pixel");
}

TEST_F(TrialTest, ListsAndMenusExplainTheirRows)
{
    QMenu views;
    fillViews(views, "shaded", [](const ViewRow&) {});
    for (qsizetype i = 0; i < views.actions().size(); ++i)
        EXPECT_EQ(views.actions()[i]->toolTip().toStdString(), kViews[std::size_t(i)].help);
    int found = 0;
    for (QMenu* menu : window.findChildren<QMenu*>()) {
        if (menu->title() != "Presets" && menu->title() != "Built-in materials" && menu->title() != "Show" && menu->title() != "Technique")
            continue;
        ++found;
        Q_EMIT menu->aboutToShow();
        EXPECT_TRUE(menu->toolTipsVisible()) << menu->title().toStdString();
        EXPECT_NE(menu->actions()[1]->toolTip(), menu->actions()[1]->text()) << menu->title().toStdString();
    }
    EXPECT_EQ(found, 4);
}
