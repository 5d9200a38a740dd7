// File choosers, none of which blocks the window's event loop, and the kinds of file that they offer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace relievo {

enum class FileKind { Source, Project, Image, Mesh, Panorama, Preset, Target, Folder };

// Whether the suffix of `file` is one of the kind's.
bool fits(FileKind kind, const QString& file);

// Opens a chooser in the folder used last for the kind (of saving: rememberSaved); `then` is called with what was chosen, not at all when
// nothing was.
void askForFile(QWidget* parent, const QString& title, FileKind kind, std::function<void(const QString&)> then);
// suffixes: the first where none is typed.
void askWhereToSave(
    QWidget* parent, const QString& title, const QString& proposal, const QStringList& suffixes, std::function<void(const QString&)> then);
// The folder of a file that could be written: the next one of its suffix is proposed there.
void rememberSaved(const QString& file);
// Asks whether what lies at `path` (a file, or files in a folder) may be replaced; `then` runs when it may.
void askToReplace(QWidget* parent, const QString& path, std::function<void()> then);

// A list to choose one line from; `then` gets its number.
void askForOne(QWidget* parent, const QString& title, const QStringList& lines, std::function<void(qsizetype)> then);

// Saving has failed, for the reason that `text` tells: it can go somewhere else.
void askToSaveElsewhere(QWidget* parent, const QString& text, std::function<void()> saveAs);

enum class Answer { Save, Discard, Cancel };
// The question before work is lost: unsaved work of `name` ("" when all is saved) and what the sentence alsoLost says (or "").
void askAboutUnsaved(QWidget* parent, const QString& name, const QString& alsoLost, std::function<void(Answer)> then);

} // namespace relievo
