// The bar of ways to compare.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/compare_bar.h"
#include "app/window/document/document.h"
#include "app/window/panels/pane_menu.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <bit>

namespace relievo {
namespace {
constexpr int kGains = 7; // 1, 2, 4 ... 64
constexpr int kBeside = 190; // px for what stands beside the ways of comparing
constexpr int kBothChoices = 320; // px from which on both choices of differences have room beside the menu

QVector<Segmented::Item> modeItems()
{
    QVector<Segmented::Item> items;
    for (const InPlaceRow& row : kInPlaceModes)
        items.append({qt(row.label), qt(row.help), {}});
    return items;
}

QComboBox* choice(const char* name, const QString& tip, const QStringList& texts = {})
{
    auto* made = new ChoiceList;
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->addItems(texts);
    made->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    return made;
}
} // namespace

CompareBar::CompareBar(Document& document, Viewport& viewport)
    : m_document(document)
    , m_viewport(viewport)
    , m_modes(new Segmented(modeItems()))
    , m_mode(choice("mode", tr("How the pictures are compared")))
    , m_first(choice("first", tr("The first of the two pictures")))
    , m_second(choice("second", tr("The second of the two pictures")))
    , m_gain(choice("gain", tr("How much differences are amplified")))
    , m_sense(
          choice("sense", tr("Absolute: black where the pictures agree. Signed: grey where they agree, brighter where the second one is."),
              {tr("Absolute"), tr("Signed")}))
    , m_number(new QLabel)
{
    setObjectName("compare-bar");
    m_modes->setObjectName("compare-modes");
    m_number->setObjectName("compare-number");
    for (const InPlaceRow& row : kInPlaceModes)
        m_mode->addItem(qt(row.label));
    for (int i = 0; i < kGains; ++i)
        m_gain->addItem(tr("x %1").arg(1 << i));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(12, 6, 12, 6);
    line->setSpacing(2 * kGrid);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_modes, m_mode, m_first, m_second, m_gain, m_sense, m_number})
        line->addWidget(widget);
    line->addStretch(1);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    InPlace& inPlace = viewport.places().inPlace();
    connect(m_modes, &Segmented::chosen, this, &CompareBar::setMode);
    connect(m_mode, &QComboBox::activated, this, &CompareBar::setMode);
    connect(m_first, &QComboBox::activated, this, [this](int pane) { choosePair(std::size_t(pane), false); });
    connect(m_second, &QComboBox::activated, this, [this](int pane) { choosePair(std::size_t(pane), true); });
    connect(m_gain, &QComboBox::activated, this, [&inPlace](int index) { inPlace.setGain(float(1 << index)); });
    connect(m_sense, &QComboBox::activated, this, [&inPlace](int index) { inPlace.setSigned(index == 1); });
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & Change::Panes)
            follow();
    });
    connect(&document, &Document::started, this, [this] { m_furtherPanes.forget(); });
    connect(&viewport.places(), &PanePlaces::arranged, this, &CompareBar::follow);
    connect(&viewport.places(), &PanePlaces::composed, this, &CompareBar::follow);
    connect(&viewport, &Viewport::painted, this, [this] { // the number goes with its picture
        if (m_viewport.places().inPlace().mode() == InPlaceMode::Flip)
            follow();
    });
    follow();
}

void CompareBar::showPanes(bool several)
{
    m_document.edit(tr("Compare two techniques"), [&](State& state) { m_furtherPanes.show(state, several); });
}

void CompareBar::showPanes(std::size_t count)
{
    m_document.edit(
        count == 1 ? tr("One picture") : tr("%1 pictures").arg(count), [&](State& state) { m_furtherPanes.show(state, count); });
}

void CompareBar::compare(InPlaceMode mode, bool on)
{
    if (on && m_document.state().panes.size() == 1)
        showPanes(true);
    m_viewport.places().inPlace().setMode(on ? mode : InPlaceMode::SideBySide);
}

bool CompareBar::compares(InPlaceMode mode) const
{
    return m_viewport.places().inPlace().isOn() && m_viewport.places().inPlace().mode() == mode;
}

void CompareBar::swap()
{
    const auto [first, second] = m_viewport.places().inPlace().pair();
    if (first != second)
        swapPanes(m_document, first, second);
}

void CompareBar::setMode(int index)
{
    m_viewport.places().inPlace().setMode(kInPlaceModes[std::size_t(index)].mode);
}

// The one that the other already shows changes places with it.
void CompareBar::choosePair(std::size_t pane, bool second)
{
    const auto [first, other] = m_viewport.places().inPlace().pair();
    if (second)
        m_viewport.places().inPlace().setPair(pane == first ? other : first, pane);
    else
        m_viewport.places().inPlace().setPair(pane, pane == other ? first : other);
}

void CompareBar::showPair()
{
    const auto [first, second] = m_viewport.places().inPlace().pair();
    QStringList names;
    for (std::size_t pane = 0; pane < m_document.state().panes.size(); ++pane)
        names.append(paneLetter(pane));
    for (QComboBox* box : {m_first, m_second}) {
        if (box->count() != names.size()) {
            box->clear();
            box->addItems(names);
        }
        box->setCurrentIndex(int(box == m_first ? first : second));
        box->setVisible(names.size() > 2 && m_viewport.places().inPlace().mode() != InPlaceMode::SideBySide);
    }
}

void CompareBar::follow()
{
    const InPlace& inPlace = m_viewport.places().inPlace();
    setVisible(m_document.state().panes.size() > 1);
    const InPlaceMode mode = inPlace.mode();
    m_modes->setCurrent(int(mode));
    m_mode->setCurrentIndex(int(mode));
    showPair();
    m_gain->setCurrentIndex(std::countr_zero(unsigned(inPlace.gain())));
    m_sense->setCurrentIndex(inPlace.isSigned());
    m_gain->setVisible(mode == InPlaceMode::Difference);
    m_number->setVisible(mode == InPlaceMode::Flip);
    if (const FlipPicture* flip = m_viewport.places().flip().picture())
        m_number->setText(tr("mean %1   most %2").arg(flip->mean, 0, 'f', 4).arg(flip->most, 0, 'f', 2));
    else
        m_number->setText(tr("computing ..."));
    fit();
}

void CompareBar::fit()
{
    const bool isWide = width() >= m_modes->sizeHint().width() + kBeside;
    m_modes->setVisible(isWide);
    m_mode->setVisible(!isWide);
    m_sense->setVisible(m_gain->isVisibleTo(this) && width() >= kBothChoices);
}

} // namespace relievo
