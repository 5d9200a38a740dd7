// Measuring batch by batch.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/live_sweep.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/text.h"
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRest = 250; // ms without a change until measuring goes on
constexpr int kCoarseRays = 2560, kSharpRays = 6000; // of the whole picture

// The parameters that rays and exact answers depend on.
State asQuestion(const State& state)
{
    State asked = ofPane(state, 0);
    asked.name.clear();
    asked.environment.clear();
    asked.slots = {};
    asked.parameters = onlyAffecting(Affects::ExactAnswer, asked.parameters);
    asked.panes = {Pane{}};
    return asked;
}

Background::Then measured(const std::function<void(const std::shared_ptr<RaySweep>&, const Expected<std::vector<SweepRow>>&)>& take,
    std::shared_ptr<RaySweep> sweep, const Expected<std::vector<SweepRow>>& rows)
{
    return [take, sweep = std::move(sweep), rows] { take(sweep, rows); };
}
} // namespace

ViewGrid gridOf(const Viewport& viewport, std::size_t pane, int rays)
{
    const auto areas = viewport.places().areas();
    const PaneArea area = pane < areas.size() && !areas[pane].isEmpty() ? areas[pane] : PaneArea{0, 0, viewport.width(), viewport.height()};
    const int columns = std::max(1, int(std::lround(std::sqrt(double(rays) * double(area.aspect())))));
    return {{columns, std::max(1, rays / columns)}, area.height, area.aspect()};
}

State ofPane(const State& state, std::size_t pane)
{
    State one = state;
    one.panes = {state.panes[std::min(pane, state.panes.size() - 1)]};
    return ofFirstPane(one);
}

std::string keyOf(const SearchSetting& setting)
{
    return std::string(setting.technique->key) + ' ' + parametersText(setting);
}

LiveSweep::LiveSweep(const Document& document, const Assets& assets, const Viewport& viewport, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_assets(assets)
    , m_viewport(viewport)
    , m_background(this)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, &LiveSweep::begin);
    connect(&m_background, &Background::failed, this, &LiveSweep::tell);
    connect(&document, &Document::changed, this, &LiveSweep::stir);
    connect(&assets, &Assets::resourcesChanged, this, &LiveSweep::stir);
    connect(&viewport, &Viewport::activePaneChanged, this, &LiveSweep::stir);
}

void LiveSweep::run(bool on)
{
    m_isOn = on;
    m_background.cancel();
    on ? m_rest.start() : m_rest.stop();
    if (!on) // nothing is held that costs room
        m_coarse.reset(), m_sharp.reset();
}

void LiveSweep::stir()
{
    if (!m_isOn)
        return;
    m_background.cancel();
    m_rest.start();
}

void LiveSweep::begin()
{
    if (m_document.inGesture())
        return m_rest.start();
    const Resources& resources = m_assets.resources();
    if (!m_assets.ready() || !m_assets.upToDate())
        return tell(tr("Waits for the files"));
    if (!resources.material->height || resources.mesh->object) {
        m_points.clear();
        return tell(resources.mesh->object ? tr("A relief object is searched by itself, not by a height map.")
                                           : tr("There is no height map to search."));
    }
    const std::size_t pane = std::size_t(m_viewport.activePane());
    const State state = ofPane(m_document.state(), pane);
    ViewQuestion question{asQuestion(state), gridOf(m_viewport, pane, kSharpRays), resources.material->height->identity(), resources.mesh};
    if (m_question != question) {
        m_figures.clear();
        m_coarse.reset(), m_sharp.reset();
        m_question = std::move(question);
    }
    m_wanted.clear();
    for (const TechniqueRow& technique : kTechniques)
        if (isChoice(technique))
            for (SearchSetting& setting : settingsOf(technique, state.parameters, kReportSteps))
                m_wanted.push_back(std::move(setting));
    const SearchSetting present = plainSetting(*findTechnique(state.panes.front().technique), state.parameters);
    m_present = keyOf(present);
    if (std::ranges::find(m_wanted, m_present, &keyOf) == m_wanted.end())
        m_wanted.insert(m_wanted.begin(), present);
    next();
}

// The first technique that lacks figures: coarse ones of all come first, then what is searched without a baked map.
LiveSweep::Batch LiveSweep::nextBatch() const
{
    const HeightField& field = *m_assets.resources().material->height;
    const bool isLarge = std::max(field.width(), field.height()) > kCoarseSide;
    for (const bool coarse : {true, false})
        for (const bool baked : {false, true}) {
            Batch batch{{}, coarse && isLarge};
            for (const SearchSetting& setting : m_wanted) {
                const auto found = m_figures.find(keyOf(setting));
                const bool isThere = found != m_figures.end() && (coarse || !found->second.isCoarse);
                if (isThere || baked == setting.technique->accelerationMap.empty())
                    continue;
                if (batch.settings.empty() || batch.settings.front().technique == setting.technique)
                    batch.settings.push_back(setting);
            }
            if (!batch.settings.empty())
                return batch;
        }
    return {};
}

void LiveSweep::next()
{
    m_points.clear();
    std::size_t sharp = 0;
    for (const SearchSetting& setting : m_wanted) {
        const std::string key = keyOf(setting);
        const auto found = m_figures.find(key);
        if (found == m_figures.end())
            continue;
        sharp += !found->second.isCoarse;
        m_points.push_back({setting, found->second.errors, found->second.isCoarse, key == m_present});
    }
    const Batch batch = nextBatch();
    if (batch.settings.empty()) {
        m_coarse.reset(), m_sharp.reset();
        return tell({});
    }
    std::shared_ptr<RaySweep>& kept = batch.isCoarse ? m_coarse : m_sharp;
    const auto take = [this, batch](const std::shared_ptr<RaySweep>& sweep, const Expected<std::vector<SweepRow>>& rows) {
        this->take(batch, sweep, rows);
    };
    m_background.start(
        [take, batch, sweep = std::exchange(kept, nullptr), state = ofPane(m_document.state(), std::size_t(m_viewport.activePane())),
            resources = m_assets.resources(), grid = m_question->grid](const Progress& progress) mutable -> Background::Then {
            if (!sweep) {
                const HeightField field = resources.material->height->withWrap(state.parameters.wrap);
                const ViewGrid asked = batch.isCoarse ? ViewGrid{grid.pixels * 2 / 3, grid.height, grid.aspect} : grid;
                auto made = RaySweep::create(batch.isCoarse ? reducedTo(field, kCoarseSide) : field,
                    {viewRays(state, 0, resources, asked, progress)}, false, progress);
                if (!made)
                    return measured(take, nullptr, tl::unexpected(made.error()));
                sweep = std::make_shared<RaySweep>(std::move(*made));
            }
            std::vector<SweepRow> rows;
            for (std::size_t i = 0; i < batch.settings.size(); ++i) {
                auto row = sweep->measure(batch.settings[i], i, 0, progress);
                if (!row)
                    return measured(take, nullptr, tl::unexpected(row.error()));
                rows.push_back(row->front());
            }
            return measured(take, sweep, rows);
        });
    tell(tr("Measuring: %1 of %2").arg(sharp).arg(m_wanted.size()));
}

void LiveSweep::take(const Batch& batch, const std::shared_ptr<RaySweep>& sweep, const Expected<std::vector<SweepRow>>& rows)
{
    if (!rows)
        return tell(QString::fromStdString(message(rows.error())));
    (batch.isCoarse ? m_coarse : m_sharp) = sweep;
    if (sweep->sets().front().rays.empty())
        return tell(tr("Nothing of the relief is in view."));
    for (const SweepRow& row : *rows)
        m_figures[keyOf(batch.settings[row.setting])] = {row.errors, batch.isCoarse};
    next();
}

void LiveSweep::tell(const QString& note)
{
    m_note = note;
    Q_EMIT changed();
}

} // namespace relievo
