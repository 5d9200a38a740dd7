// Targets of the user's own: files in a folder of the settings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include <QString>
#include <vector>

namespace relievo {

struct OwnTarget {
    QString file; // in the folder, absolute
    const ExportRow* row = nullptr; // good until the program ends; null: it cannot be used
    QString fault = {}; // why, in a sentence
};

QString ownTargetsFolder(); // where they lie; it need not be there
bool makeOwnTargetsFolder();

// The .tpl and .json files of the folder by name. One that has not changed since is not read again.
std::vector<OwnTarget> ownTargets();
QString ownTargetPath(const QString& file); // where a file is copied to
// Copies a file into the folder, over one of the same name; sound or not, `ownTargets` lists it then. Errors: it cannot be copied.
Expected<QString> addOwnTarget(const QString& file);

} // namespace relievo
