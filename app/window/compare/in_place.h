// Two panes compared in one place: parted by a line, one after the other, or by their difference.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_layout.h"
#include "render/compose.h"
#include <QObject>
#include <QTimer>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

class QKeyEvent;
class QMouseEvent;
class QWidget;

namespace relievo {

class Document;

enum class InPlaceMode { SideBySide, Wipe, Blink, Difference, Flip };
struct InPlaceRow {
    InPlaceMode mode;
    std::string_view label, help;
};
inline constexpr auto kInPlaceModes = std::to_array<InPlaceRow>({
    {InPlaceMode::SideBySide, "Side by side", "Every picture beside the others"},
    {InPlaceMode::Wipe, "Wipe", "One picture left of the line, the other right of it; drag the line, turn it with Shift"},
    {InPlaceMode::Blink, "Blink", "One picture, then the other; V holds the other one"},
    {InPlaceMode::Difference, "Difference", "How far the pictures are apart, channel by channel, of the values shown"},
    {InPlaceMode::Flip, "FLIP", "How different the pictures look when one flips to the other, 0 to 1 (Andersson et al. 2020)"},
});

// Of the panes of a document in a widget, which owns it; hears its mouse and keys before others do.
class InPlace : public QObject {
    Q_OBJECT
public:
    InPlace(Document& document, QWidget* widget);

    InPlaceMode mode() const { return m_mode; } // as chosen; with a single pane nothing is compared
    void setMode(InPlaceMode mode);
    void setPair(std::size_t first, std::size_t second);
    std::pair<std::size_t, std::size_t> pair() const; // panes that there are
    float gain() const { return m_gain; }
    void setGain(float gain); // of differences, 1 to 64
    bool isSigned() const { return m_isSigned; }
    void setSigned(bool isSigned);

    bool isOn() const; // now: one place for two panes
    Composition composition() const; // of the pair, when it is on; of Mode::Flip by the map of FLIP as the first picture
    // Where the panes lie in a viewport of so many pixels; empty for those that are not shown.
    std::vector<PaneArea> areas(int width, int height) const;
    // Where there is room for what is said of each.
    std::vector<PaneArea> captionAreas(int width, int height) const;
    // Which pane is seen at a point of the widget.
    std::size_t paneAt(QPointF position) const;

Q_SIGNALS:
    void arranged(); // other panes, or at other places
    void composed(); // the same panes, put together otherwise

protected:
    bool eventFilter(QObject* widget, QEvent* event) override;

private:
    enum class Grip { None, Move, Turn };
    glm::vec2 shareOf(QPointF position) const;
    bool isNearLine(QPointF position) const;
    bool mouse(const QMouseEvent& event);
    bool key(const QKeyEvent& event);
    void hold(bool other);
    Document& m_document;
    QWidget* m_widget;
    InPlaceMode m_mode = InPlaceMode::SideBySide;
    std::pair<std::size_t, std::size_t> m_pair{0, 1};
    glm::vec2 m_divider{0.5f};
    float m_angle = 0.f, m_gain = 1.f;
    bool m_isSigned = false, m_holds = false, m_blinked = false;
    Grip m_grip = Grip::None;
    bool m_pointsAtLine = false;
    QTimer m_blinking;
};

} // namespace relievo
