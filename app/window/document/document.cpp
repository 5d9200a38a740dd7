// The one way in which the window changes what it shows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/document.h"
#include "core/ground/shown_text.h"
#include "core/state/state_json.h"
#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace relievo {

Changes differences(const State& a, const State& b)
{
    Changes what;
    what.setFlag(Change::Name, a.name != b.name);
    Parameters sameMoment = a.parameters;
    sameMoment.time = b.parameters.time, sameMoment.lightTurn = b.parameters.lightTurn;
    what.setFlag(Change::Parameters, sameMoment != b.parameters);
    what.setFlag(Change::Moment, a.parameters.time != b.parameters.time || a.parameters.lightTurn != b.parameters.lightTurn);
    what.setFlag(Change::Maps, a.slots != b.slots);
    what.setFlag(Change::Mesh, a.mesh != b.mesh || a.part != b.part);
    what.setFlag(Change::Environment, a.environment != b.environment);
    const auto plain = [](const State& state) { // the panes without what has a flag of its own
        std::vector<Pane> panes = state.panes;
        for (Pane& pane : panes) {
            pane.view.clear();
            if (pane.camera)
                pane.camera = Camera{};
        }
        return panes;
    };
    bool ownCameraMoved = false; // of an unlinked pane
    for (std::size_t pane = 0; pane < std::min(a.panes.size(), b.panes.size()); ++pane)
        ownCameraMoved = ownCameraMoved || (a.panes[pane].camera && b.panes[pane].camera && a.panes[pane].camera != b.panes[pane].camera);
    what.setFlag(Change::Camera, a.camera != b.camera || ownCameraMoved);
    what.setFlag(Change::View, !std::ranges::equal(a.panes, b.panes, {}, &Pane::view, &Pane::view));
    what.setFlag(Change::Panes, plain(a) != plain(b));
    return what;
}

namespace {
// What is no change of the work: where the eye is, and at which moment it looks.
void keepCameraAndMoment(State& state, const State& from)
{
    state.camera = from.camera;
    state.parameters.time = from.parameters.time, state.parameters.lightTurn = from.parameters.lightTurn;
    for (std::size_t pane = 0; pane < std::min(state.panes.size(), from.panes.size()); ++pane)
        if (state.panes[pane].camera && from.panes[pane].camera)
            state.panes[pane].camera = from.panes[pane].camera;
}
} // namespace

// Two whole States; camera and moment of neither are used, so that undo leaves the eye where it is.
class Document::Edit : public QUndoCommand {
public:
    Edit(Document& document, State after, const QString& text)
        : QUndoCommand(text)
        , m_document(document)
        , m_before(document.m_state)
        , m_after(std::move(after))
        , m_gesture(document.m_gesture)
    {
    }
    int id() const override { return 1; }
    void undo() override { show(m_before); }
    void redo() override { std::exchange(m_isNew, false) ? m_document.replace(m_after) : show(m_after); }
    bool mergeWith(const QUndoCommand* next) override
    {
        const auto* other = static_cast<const Edit*>(next);
        if (other->m_gesture != m_gesture || other->text() != text())
            return false;
        m_after = other->m_after;
        State sameCamera = m_after;
        keepCameraAndMoment(sameCamera, m_before);
        setObsolete(sameCamera == m_before);
        return true;
    }

private:
    void show(State state)
    {
        keepCameraAndMoment(state, m_document.m_state);
        m_document.replace(state);
    }
    Document& m_document;
    State m_before, m_after;
    int m_gesture;
    bool m_isNew = true; // done for the first time: the edit may move the eye too
};

Document::Document(QObject* parent) : QObject(parent)
{
    connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

void Document::edit(const QString& text, const std::function<void(State&)>& change)
{
    State after = m_state;
    change(after);
    fitTechniques(after);
    State sameCamera = after;
    keepCameraAndMoment(sameCamera, m_state);
    if (sameCamera == m_state) {
        replace(after);
        if (!text.isEmpty() && !inGesture())
            Q_EMIT choseAgain();
        return;
    }
    m_undo.push(new Edit(*this, std::move(after), text));
    if (!inGesture())
        ++m_gesture;
}

void Document::beginGesture()
{
    if (m_depth++ == 0)
        ++m_gesture;
}

void Document::resumeGesture()
{
    if (m_depth++ == 0)
        --m_gesture; // the number that it had before its end
}

void Document::endGesture()
{
    if (m_depth == 0 || --m_depth > 0)
        return;
    ++m_gesture;
    Q_EMIT gestureEnded();
}

void Document::start(const State& state, const QString& file)
{
    m_undo.clear();
    m_file = file;
    m_began = state;
    ++m_gesture;
    replace(state);
    Q_EMIT started();
    Q_EMIT titleChanged();
}

Expected<void> Document::save(const QString& file)
{
    if (Expected<void> written = writeState(m_state, file.toStdString()); !written)
        return written;
    m_file = file;
    m_undo.setClean();
    ++m_gesture;
    Q_EMIT titleChanged();
    return {};
}

QString Document::name() const
{
    return m_file.isEmpty() ? QString::fromStdString(shownName(m_state.name)) : QFileInfo(m_file).completeBaseName();
}

void Document::replace(const State& next)
{
    const Changes what = differences(m_state, next);
    m_state = next;
    if (what)
        Q_EMIT changed(what);
    if (what & Change::Name)
        Q_EMIT titleChanged();
}

} // namespace relievo
