// The sections of the map panel for what the maps are seen on and in: the mesh and the environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/widgets/section.h"
#include "core/state/state.h"

class QComboBox;

namespace relievo {

class ElidedLabel;
class Segmented;
struct Mesh;

class MeshSection : public Section {
    Q_OBJECT
public:
    explicit MeshSection(QWidget* parent = nullptr);
    // mesh: what is loaded for state.mesh; null before it is, and when a plane stands in for what is missing.
    void show(const State& state, const Mesh* mesh, bool missing);

Q_SIGNALS:
    void chosen(const QString& nameOrFile);
    void partChosen(const QString& material); // of those that the mesh names; "" for all parts

private:
    void addLines();
    void showParts(const State& state, const Mesh* mesh);
    Segmented* m_shapes;
    QComboBox* m_parts;
    ElidedLabel *m_name, *m_facts;
};

// A panorama can be dropped on it; whatever else is left to the window.
class EnvironmentSection : public Section {
    Q_OBJECT
public:
    explicit EnvironmentSection(QWidget* parent = nullptr);
    void show(const State& state, bool missing);

Q_SIGNALS:
    void chosen(const QString& nameOrFile);

protected:
    bool event(QEvent* event) override;

private:
    QComboBox* m_choice; // the built-in ones, and the panorama while there is one
    ElidedLabel* m_name; // its file
};

} // namespace relievo
