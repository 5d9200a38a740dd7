// Asking and answering of tuning.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/tune_panel.h"
#include "app/window/decide/live_sweep.h"
#include "app/window/decide/speed_page.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/analysis/report.h"
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

namespace relievo {
namespace {
constexpr int kRays = 2560; // of a view

// Limits and units of the fields; what a row is of does not matter to them.
constexpr ParameterRow limit(std::string_view key, float max, std::string_view unit, std::string_view help)
{
    return {.member = &Parameters::errorRange, .key = key, .label = key, .group = Group::View, .max = max, .unit = unit, .help = help};
}
constexpr ParameterRow kErrorRows[] = {limit("depth-error", 1.f, "", "RMSE of the depth found, share of the relief's depth"),
    limit("pixels-error", 100.f, "px", "RMSE of the texture's shift, pixels"), limit("flip-error", 1.f, "", "Mean FLIP, 0 to 1")};
constexpr ParameterRow kMissedRow = limit("missed", 100.f, "%", "Rays that may go through the first surface, in the worst view");
constexpr ParameterRow kFetchesRow = limit("fetches", 4096.f, "", "Texture fetches a ray, mean of the views");

struct ViewsRow {
    TuneViews views;
    const char *label, *help;
};
constexpr ViewsRow kViewsRows[] = {
    {TuneViews::Angles, QT_TRANSLATE_NOOP("TunePanel", "All angles"),
        QT_TRANSLATE_NOOP("TunePanel", "On a plane, from straight down to grazing, as relievo tune")},
    {TuneViews::Seen, QT_TRANSLATE_NOOP("TunePanel", "This view"), QT_TRANSLATE_NOOP("TunePanel", "This mesh from this side")},
    {TuneViews::Around, QT_TRANSLATE_NOOP("TunePanel", "Turntable"), QT_TRANSLATE_NOOP("TunePanel", "Eight views around the mesh")},
    {TuneViews::Clip, QT_TRANSLATE_NOOP("TunePanel", "Animation"),
        QT_TRANSLATE_NOOP("TunePanel", "This view of eight moments of the animation")},
};

QTableWidgetItem* cell(const QString& text, bool isNumber = true)
{
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    item->setFlags(Qt::ItemIsEnabled);
    return item;
}

} // namespace

TunePanel::TunePanel(Document& document, const Assets& assets, const Viewport& viewport)
    : m_document(document)
    , m_assets(assets)
    , m_viewport(viewport)
    , m_background(this)
    , m_goal(new Segmented({{tr("Least cost"), tr("The cheapest setting within an error"), {}},
          {tr("Least error"), tr("The most exact setting within a number of fetches"), {}}}))
    , m_metric(new Segmented({{tr("Depth"), qt(kErrorRows[0].help), {}}, {tr("Pixels"), qt(kErrorRows[1].help), {}},
          {tr("FLIP"), qt(kErrorRows[2].help), {}}}))
    , m_missed(new NumberField(kMissedRow))
    , m_fetches(new NumberField(kFetchesRow))
    , m_maxErrors{0.01, 1., 0.02}
    , m_views(new ChoiceList)
    , m_find(new QPushButton(tr("Find")))
    , m_apply(new QPushButton(tr("Use it")))
    , m_found(new QLabel)
    , m_figures(new QLabel)
    , m_proof(new QTableWidget)
{
    setObjectName("tune");
    auto* inside = new QWidget; // scrolls in a narrow window
    setWidget(inside);
    setWidgetResizable(true);
    auto* layout = new QHBoxLayout(inside);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4 * kGrid);
    layout->addLayout(form());
    layout->addLayout(result(), 1);
    connect(
        &m_background, &Background::progressed, this, [this](float share) { m_find->setText(tr("Stop (%1 %)").arg(int(100.f * share))); });
    connect(&m_background, &Background::busyChanged, this, [this](bool busy) { m_find->setText(busy ? tr("Stop") : tr("Find")); });
    connect(&m_background, &Background::failed, this, &TunePanel::clear);
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & (Changes(Change::Maps) | Change::Mesh)) // found for another relief
            clear({});
    });
    TuneQuestion first;
    first.budget.maxError = m_maxErrors[0];
    setQuestion(first);
    clear(tr("Says which technique and setting is the cheapest that errs no more than this, and proves it."));
}

QLayout* TunePanel::form()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid);
    m_goal->setObjectName("goal");
    m_metric->setObjectName("metric");
    m_views->setObjectName("views");
    m_find->setObjectName("find");
    for (const ViewsRow& row : kViewsRows) {
        m_views->addItem(tr(row.label));
        m_views->setItemData(m_views->count() - 1, tr(row.help), Qt::ToolTipRole);
    }
    auto* errors = new QHBoxLayout;
    errors->addWidget(m_metric);
    for (std::size_t i = 0; i < m_errors.size(); ++i) {
        m_errors[i] = new NumberField(kErrorRows[i]);
        m_errors[i]->setObjectName(qt(kErrorRows[i].key));
        m_errors[i]->setToolTip(qt(kErrorRows[i].help));
        m_errors[i]->setFixedWidth(64);
        errors->addWidget(m_errors[i]);
        connect(m_errors[i], &NumberField::entered, this, [this, i](double value) { m_maxErrors[i] = value; });
    }
    auto* own = new QWidget;
    errors->setContentsMargins(0, 0, 0, 0);
    own->setLayout(errors);
    connect(m_missed, &NumberField::entered, this, [this](double value) { m_maxMissed = value; });
    connect(m_fetches, &NumberField::entered, this, [this](double value) { m_maxFetches = value; });
    for (NumberField* field : {m_missed, m_fetches})
        field->setFixedWidth(64);
    m_missed->setObjectName("missed");
    m_missed->setToolTip(qt(kMissedRow.help));
    m_fetches->setObjectName("most-fetches");
    m_fetches->setToolTip(qt(kFetchesRow.help));
    line(*grid, tr("Find"), m_goal);
    line(*grid, tr("Error"), own);
    m_fetchesLabel = line(*grid, tr("Fetches, at most"), m_fetches);
    line(*grid, tr("Missed, at most"), m_missed);
    line(*grid, tr("Seen from"), m_views);
    grid->addWidget(m_find, grid->rowCount(), 1, Qt::AlignLeft);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(m_goal, &Segmented::chosen, this, &TunePanel::fieldsChanged);
    connect(m_metric, &Segmented::chosen, this, &TunePanel::fieldsChanged);
    connect(m_find, &QPushButton::clicked, this, &TunePanel::find);
    return grid;
}

QLabel* TunePanel::line(QGridLayout& grid, const QString& label, QWidget* widget)
{
    auto* text = new QLabel(label);
    setRole(*text, "dim");
    text->setBuddy(widget);
    widget->setAccessibleName(label);
    const int row = grid.rowCount();
    grid.addWidget(text, row, 0);
    grid.addWidget(widget, row, 1, Qt::AlignLeft);
    return text;
}

QLayout* TunePanel::result()
{
    m_found->setObjectName("found");
    m_found->setWordWrap(true);
    m_found->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setRole(*m_figures, "dim");
    m_figures->setWordWrap(true);
    m_figures->setObjectName("figures");
    m_apply->setObjectName("apply");
    m_apply->setToolTip(tr("Draws the active picture so"));
    connect(m_apply, &QPushButton::clicked, this, &TunePanel::apply);
    m_proof->setObjectName("proof");
    m_proof->setColumnCount(5);
    m_proof->setHorizontalHeaderLabels({tr("View"), tr("Fetches"), tr("Most"), tr("Error"), tr("Missed")});
    m_proof->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_proof->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_proof->setStyleSheet("QHeaderView::section { padding: 3px; } QTableView::item { padding: 0 2px; }"); // five columns in a narrow dock
    m_proof->horizontalHeaderItem(3)->setToolTip(tr("RMSE of the depth, share of the relief's depth"));
    m_proof->horizontalHeaderItem(4)->setToolTip(tr("Rays that go through the first surface, %"));
    m_proof->setMinimumHeight(48);
    m_proof->horizontalHeader()->setFont(smallFont());
    m_proof->verticalHeader()->hide();
    m_proof->verticalHeader()->setDefaultSectionSize(20);
    m_proof->setFont(smallFont());
    m_proof->setShowGrid(false);
    auto* head = new QHBoxLayout;
    head->addWidget(m_found, 1);
    head->addWidget(m_apply, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(kGrid);
    column->addLayout(head);
    column->addWidget(m_figures);
    column->addWidget(m_proof, 1);
    column->addStretch();
    return column;
}

TuneQuestion TunePanel::question() const
{
    TuneQuestion question;
    const std::size_t metric = std::size_t(m_metric->current());
    question.metric = kTuneMetrics[metric].metric;
    question.views = kViewsRows[m_views->currentIndex()].views;
    question.leastError = m_goal->current() == 1;
    question.budget = {m_maxErrors[metric], m_maxMissed / 100.};
    if (question.leastError)
        question.budget.maxFetches = m_maxFetches;
    question.grid = gridOf(m_viewport, std::size_t(m_viewport.activePane()), kRays);
    return question;
}

void TunePanel::setQuestion(const TuneQuestion& question)
{
    const std::size_t metric = std::size_t(question.metric);
    m_goal->setCurrent(question.leastError ? 1 : 0);
    m_metric->setCurrent(int(metric));
    m_views->setCurrentIndex(int(question.views));
    m_maxErrors[metric] = question.budget.maxError;
    m_maxMissed = 100. * question.budget.maxMissed;
    if (std::isfinite(question.budget.maxFetches))
        m_maxFetches = question.budget.maxFetches;
    for (std::size_t i = 0; i < m_errors.size(); ++i)
        m_errors[i]->setValue(m_maxErrors[i]);
    m_missed->setValue(m_maxMissed);
    m_fetches->setValue(m_maxFetches);
    fieldsChanged();
}

void TunePanel::fieldsChanged()
{
    const bool leastError = m_goal->current() == 1;
    for (std::size_t i = 0; i < m_errors.size(); ++i)
        m_errors[i]->setVisible(!leastError && int(i) == m_metric->current());
    m_fetches->setVisible(leastError);
    m_fetchesLabel->setVisible(leastError);
}

void TunePanel::hideEvent(QHideEvent* event)
{
    QScrollArea::hideEvent(event);
    m_background.cancel();
}

void TunePanel::find()
{
    if (busy())
        return m_background.cancel();
    if (!m_assets.ready() || !m_assets.upToDate())
        return clear(tr("Waits for the files: try again when they are there."));
    for (NumberField* field : findChildren<NumberField*>())
        field->commit();
    clear(tr("Measuring ..."));
    m_background.start([this, question = question(), state = ofPane(m_document.state(), std::size_t(m_viewport.activePane())),
                           resources = m_assets.resources()](const Progress& progress) -> Background::Then {
        auto tuned = std::make_shared<Expected<Tuned>>(tune(state, resources, question, progress));
        return [this, question, tuned] { take(question, *tuned); };
    });
}

void TunePanel::take(const TuneQuestion& question, const Expected<Tuned>& tuned)
{
    if (!tuned)
        return clear(QString::fromStdString(message(tuned.error())));
    if (!tuned->chosen)
        return clear(question.leastError ? tr("No setting is as cheap as that. Allow more fetches or more missed rays.")
                                         : tr("No setting is that exact. Allow more error or more missed rays."));
    m_answer = *tuned;
    const Candidate& chosen = tuned->candidates[*tuned->chosen];
    const SearchSetting& setting = tuned->settings[chosen.setting];
    m_found->setText("<b>" + qt(setting.label).toHtmlEscaped() + "</b>");
    const std::size_t metric = std::size_t(question.metric);
    m_figures->setText(
        tr("%1 fetches a ray. In the worst view: %2 %3, missed %4 %. %5 of %6 settings are cheaper%7.")
            .arg(qt(figure(chosen.meanFetches)), qt(kTuneMetrics[metric].label), qt(figure(chosen.error)), qt(figure(100. * chosen.missed)))
            .arg(*tuned->chosen)
            .arg(tuned->candidates.size())
            .arg(question.leastError ? QString() : tr(", all of them too wrong")));
    fillProof(*tuned, chosen);
    m_apply->show();
}

void TunePanel::fillProof(const Tuned& tuned, const Candidate& candidate)
{
    m_proof->setRowCount(0);
    for (const SweepRow& row : tuned.rows) {
        if (row.setting != candidate.setting)
            continue;
        const int at = m_proof->rowCount();
        m_proof->insertRow(at);
        const QString view = qt(tuned.views[row.band]);
        m_proof->setItem(at, 0, cell(view, false));
        m_proof->setItem(at, 1, cell(qt(figure(row.errors.meanFetches))));
        m_proof->setItem(at, 2, cell(QString::number(row.errors.maxFetches)));
        m_proof->setItem(at, 3, cell(qt(figure(row.errors.rmse))));
        m_proof->setItem(at, 4, cell(qt(figure(100. * row.errors.share(row.errors.tooDeep)))));
    }
    m_proof->show();
}

void TunePanel::clear(const QString& why)
{
    m_answer.reset();
    m_found->setText(why);
    m_figures->clear();
    m_proof->setRowCount(0);
    m_proof->hide();
    m_apply->hide();
}

void TunePanel::apply()
{
    if (m_answer)
        applySetting(m_document, std::size_t(m_viewport.activePane()), m_answer->settings[m_answer->candidates[*m_answer->chosen].setting]);
}

} // namespace relievo
