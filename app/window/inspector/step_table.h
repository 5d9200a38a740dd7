// The steps of a search as a table to scrub through.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/ray_inspection.h"
#include <QTableWidget>

namespace relievo {

// Where on the ray a step reads, in t: of a halving the middle of its bracket, else where it ends.
double readAt(const RayInspection& ray, const SearchStep& step);

class StepTable : public QTableWidget {
    Q_OBJECT
public:
    explicit StepTable(QWidget* parent = nullptr);
    void show(const RayInspection* ray); // null: empty

Q_SIGNALS:
    void chosen(int step); // -1: none
};

} // namespace relievo
