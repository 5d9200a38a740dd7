// What the File menu and dropped files do to the document.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QObject>
#include <functional>

class QMenu;

namespace relievo {

class Files : public QObject {
    Q_OBJECT
public:
    Files(Document& document, Assets& assets, Messages& messages, QWidget* window);

    bool unsaved() const; // also when what was dropped or chosen is still loading
    // `then` runs at once when nothing is unsaved, else after the question, unless it is cancelled or saving fails.
    // alsoLost: a sentence on other work that `then` ends; it is asked about too.
    void guard(std::function<void()> then, const QString& alsoLost = {});

    void startNew();
    void ask(); // for a project or image, then opens it
    void askFolder();
    void open(const QString& source); // a new document, after the question
    // Asks where to when the document has no file yet, and waits for what is still loading; `then` does not run when that fails.
    void save(std::function<void()> then = {});
    void saveAs(std::function<void()> then = {});
    // A glTF file with pictures is asked about: material and mesh, or one of them. Another mesh replaces the mesh, a project the document,
    // an image or folder the maps, a preset the numbers.
    void openDropped(const QString& dropped);

    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);
    void fillPresets(QMenu& menu);
    void applyPreset(const std::string& nameOrFile); // its numbers and technique; the maps stay

private:
    void takeMesh(const QString& file);
    void askWhatToTake(const QString& gltf);
    void saveTo(const QString& file, const std::function<void()>& then);
    Document& m_document;
    Assets& m_assets;
    Messages& m_messages;
    QWidget* m_window;
};

} // namespace relievo
