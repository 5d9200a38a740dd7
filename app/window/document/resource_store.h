// What is shown: the loaded files of the document with the defaults that stand in for what is missing, and whether they fit a State.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/stand_ins.h"
#include <QString>
#include <utility>
#include <vector>

namespace relievo {

// What has to be loaded or made for a State: its files, and the acceleration maps of its panes.
struct Needs {
    MapSlots slots;
    std::string mesh, environment;
    std::vector<MapWish> accelerationMaps;
    bool operator==(const Needs&) const = default;
};
Needs needsOf(const State& state);

class ResourceStore {
public:
    // Never half a set: all members, or (before the first load) none.
    const Resources& resources() const { return m_shown.resources; }
    const Shown& shown() const { return m_shown; }
    void show(Shown shown) { m_shown = std::move(shown); }
    void readAgain(const FileNames& files) { m_shown.stale.insert(files.begin(), files.end()); } // with whatever is loaded next

    bool ready() const { return resources().material && resources().mesh && resources().environment; }
    // Whether the files that `state` names are those that are loaded or stood in for, and none is to be read again.
    bool isLoaded(const State& state) const;
    // Also the acceleration maps that its techniques search with are there.
    bool isComplete(const State& state) const;
    bool locatesMesh(const State& state, const QString& file) const; // its mesh is missing, and `file` has that one's name
    // The acceleration map that alone keeps `state` from being drawn, in the words of its row; "" when there is none, or files miss too.
    QString missingMap(const State& state) const;

private:
    Shown m_shown;
};

} // namespace relievo
