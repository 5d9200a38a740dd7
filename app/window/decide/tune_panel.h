// Tuning: what may be wrong, or what it may cost; the best setting within that, with its proof, taken over by a button.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "render/measure/tuning.h"
#include <QScrollArea>
#include <array>
#include <optional>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableWidget;

namespace relievo {

class NumberField;
class Segmented;
class Viewport;

// The same answer as `relievo tune` gives to the same question. Works in the background, not while it is hidden.
class TunePanel : public QScrollArea {
    Q_OBJECT
public:
    TunePanel(Document& document, const Assets& assets, const Viewport& viewport);
    TuneQuestion question() const; // as the fields have it
    void setQuestion(const TuneQuestion& question);
    void find(); // starts, or stops what runs
    void apply(); // what was found, to the active pane, as one undo step
    const std::optional<Tuned>& answer() const { return m_answer; }
    bool busy() const { return m_background.busy(); }

protected:
    void hideEvent(QHideEvent*) override;

private:
    QLayout* form();
    QLayout* result();
    QLabel* line(QGridLayout& grid, const QString& label, QWidget* widget);
    void fieldsChanged();
    void take(const TuneQuestion& question, const Expected<Tuned>& tuned);
    void clear(const QString& why);
    void fillProof(const Tuned& tuned, const Candidate& candidate);
    Document& m_document;
    const Assets& m_assets;
    const Viewport& m_viewport;
    Background m_background;
    Segmented *m_goal, *m_metric;
    std::array<NumberField*, 3> m_errors; // of each metric
    NumberField *m_missed, *m_fetches;
    std::array<double, 3> m_maxErrors; // as entered, in the command's units
    double m_maxMissed = 100., m_maxFetches = 64.; // percent; a ray
    QComboBox* m_views;
    QPushButton *m_find, *m_apply;
    QLabel *m_found, *m_figures, *m_fetchesLabel;
    QTableWidget* m_proof;
    std::optional<Tuned> m_answer;
};

} // namespace relievo
