// Measures every technique and setting on what the active pane shows, in the background, coarse first.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/analysis/decide/view_rays.h"
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace relievo {

class Viewport;

// What is measured: the relief as the active pane sees it. What does not change the figures is left at its default, so that equal
// questions have equal figures.
struct ViewQuestion {
    State state; // one pane
    ViewGrid grid;
    std::shared_ptr<const void> heights; // HeightField::identity
    std::shared_ptr<const Mesh> mesh;
    bool operator==(const ViewQuestion&) const = default;
};

struct MeasuredSetting {
    SearchSetting setting;
    HitErrors errors;
    bool isCoarse = false; // on heights reduced to kCoarseSide
    bool isPresent = false; // what the active pane is drawn with
};
inline constexpr int kCoarseSide = 256; // texels

// At rest while `run(false)`, and while anything changes or is dragged: the picture goes first. Figures are kept as long as mesh, heights
// and view stay, and measured anew when they do not.
class LiveSweep : public QObject {
    Q_OBJECT
public:
    LiveSweep(const Document& document, const Assets& assets, const Viewport& viewport, QObject* parent = nullptr);
    void run(bool on);
    bool busy() const { return m_background.busy() || m_rest.isActive(); }
    const std::vector<MeasuredSetting>& points() const { return m_points; } // those that are measured
    const QString& note() const { return m_note; } // how far it is, or why there is nothing

Q_SIGNALS:
    void changed();

private:
    struct Figures {
        HitErrors errors;
        bool isCoarse = false;
    };
    struct Batch { // settings of one technique
        std::vector<SearchSetting> settings;
        bool isCoarse = false;
    };
    void stir(); // something changed
    void begin();
    void next();
    Batch nextBatch() const;
    void take(const Batch& batch, const std::shared_ptr<RaySweep>& sweep, const Expected<std::vector<SweepRow>>& rows);
    void tell(const QString& note);
    const Document& m_document;
    const Assets& m_assets;
    const Viewport& m_viewport;
    Background m_background;
    QTimer m_rest;
    bool m_isOn = false;
    std::optional<ViewQuestion> m_question;
    std::vector<SearchSetting> m_wanted;
    std::string m_present; // keyOf what the pane is drawn with
    std::map<std::string, Figures> m_figures; // by keyOf a setting
    std::shared_ptr<RaySweep> m_coarse, m_sharp; // of the question; a batch that runs holds its own
    std::vector<MeasuredSetting> m_points;
    QString m_note;
};

// The pane's picture in pixels of the screen, and rays over it, about `rays` of them.
ViewGrid gridOf(const Viewport& viewport, std::size_t pane, int rays);
// The pane as the only one, with its own values and camera.
State ofPane(const State& state, std::size_t pane);
// Technique and values that its search reads.
std::string keyOf(const SearchSetting& setting);

} // namespace relievo
