// The large data behind the document (maps, mesh, environment), loaded in the background and kept in step with it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/background.h"
#include "app/window/document.h"
#include "app/window/messages.h"
#include "core/source.h"
#include <QObject>
#include <functional>

namespace relievo {

// Everything here returns at once. A failure leaves document and data as they were and stands in the messages under "load".
class Assets : public QObject {
    Q_OBJECT
public:
    Assets(Document& document, Messages& messages, QObject* parent = nullptr);

    // Never half a set: all members, or (before the first load) none.
    const Resources& resources() const { return m_resources; }
    bool ready() const { return m_resources.material && m_resources.mesh && m_resources.environment; }
    Background& background() { return m_background; }

    // Opens a SOURCE of cli.md as a new document. Maps keep the present mesh, camera and parameters; a project replaces all.
    void openDocument(const QString& source);
    void openDocument(const QString& source, const State& base, bool counted = true); // counted: among the recent files
    void openState(const State& state, const Warnings& warnings); // untitled
    // Takes maps into the present document, as one undo step, when that holds work; else as openDocument.
    void openInto(const QString& source);

    // An edit that needs other files: they are loaded first, and the document changes only when all that is new could be read.
    void propose(const QString& text, std::function<void(State&)> change);

Q_SIGNALS:
    void resourcesChanged();

private:
    struct Loaded;
    static Loaded open(const std::string& source, const State& base, const Resources& previous, const Progress& progress);
    void take(const Resources& resources);
    void follow(Changes what);
    void refuse(const Error& error);
    bool fits(const State& state) const;
    Document& m_document;
    Messages& m_messages;
    Resources m_resources;
    Background m_background;
};

} // namespace relievo
