// Loading for the window: first the files, then the change.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/assets.h"
#include "app/window/recent_files.h"
#include "core/mesh/pictures.h"
#include <QFileInfo>
#include <algorithm>

namespace relievo {

struct Assets::Loaded {
    Opened opened;
    Resources resources;
    std::optional<Error> error;
};

namespace {
bool holds(const Material& material, MapKind kind)
{
    return kind == MapKind::Height ? material.height.has_value() : material.map(kind) != nullptr;
}

// A map that `next` names anew but that could not be read.
std::optional<Error> newMapThatFailed(const State& before, const State& next, const Material& material)
{
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = next.slots[std::size_t(row.kind)];
        if (slot.empty() || slot == before.slots[std::size_t(row.kind)] || holds(material, row.kind))
            continue;
        for (const Warning& warning : material.warnings)
            if (warning.text.find(slot.file) != std::string::npos)
                return Error{warning.text.ends_with('.') ? warning.text.substr(0, warning.text.size() - 1) : warning.text, "", ""};
        return Error{"the map could not be read", slot.file, "Choose another file"};
    }
    return {};
}

bool cancelled(const Error& error)
{
    return error.what == "cancelled";
}

bool isThere(const MapSlot& slot)
{
    return slot.file.starts_with("sample:") || pictureMayExist(slot.file);
}

// The material of slots whose files have all moved: empty, and it says which.
std::shared_ptr<const Material> movedAway(const MapSlots& slots)
{
    Material material;
    material.slots = slots;
    for (const MapKindRow& kind : kMapKinds)
        if (const MapSlot& slot = slots[std::size_t(kind.kind)]; !slot.empty())
            material.warnings.push_back(
                {"map-missing", slot.file + ": the " + std::string(kind.label) + " map is not there. Locate or clear it."});
    return std::make_shared<const Material>(std::move(material));
}

// Loads for a State that must be shown even when the files of all its maps have moved.
Expected<Resources> loadWhatIsThere(const State& state, const DecodedImages& images, Resources previous, const Progress& progress)
{
    if (state.slots != MapSlots{} && std::ranges::none_of(state.slots, isThere))
        previous.material = movedAway(state.slots);
    return loadResources(state, images, previous, progress);
}
} // namespace

Assets::Assets(Document& document, Messages& messages, QObject* parent) : QObject(parent), m_document(document), m_messages(messages)
{
    connect(&document, &Document::changed, this, &Assets::follow);
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        m_messages.set("load", Error{what.toStdString(), m_document.state().name, "Use smaller maps or meshes"});
    });
}

Assets::Loaded Assets::open(const std::string& source, const State& base, const Resources& previous, const Progress& progress)
{
    const auto part = [&](float from, float to) {
        return Progress{[&progress, from, to](float share) { progress.at(from + (to - from) * share); }, progress.stop};
    };
    Loaded result;
    auto opened = openSource(source, base, part(0.f, 0.6f));
    if (!opened) {
        result.error = opened.error();
        return result;
    }
    result.opened = std::move(*opened);
    auto resources = loadWhatIsThere(result.opened.state, result.opened.images, previous, part(0.6f, 1.f));
    if (resources)
        result.resources = *resources;
    else
        result.error = resources.error();
    return result;
}

void Assets::openDocument(const QString& source)
{
    openDocument(source, m_document.state());
}

void Assets::openDocument(const QString& source, const State& base, bool counted)
{
    m_background.start([this, source, base, counted, previous = m_resources](const Progress& progress) -> Background::Then {
        const Loaded loaded = open(source.toStdString(), base, previous, progress);
        return [this, source, counted, loaded] {
            if (loaded.error)
                return refuse(*loaded.error);
            m_messages.set("opened", loaded.opened.warnings);
            take(loaded.resources);
            const bool project = isProjectFile(source.toStdString());
            m_document.start(loaded.opened.state, project ? QFileInfo(source).absoluteFilePath() : QString());
            if (counted && !isBuiltInSource(source.toStdString()))
                addRecentFile(QFileInfo(source).absoluteFilePath());
        };
    });
}

void Assets::openState(const State& state, const Warnings& warnings)
{
    m_background.start([this, state, warnings, previous = m_resources](const Progress& progress) -> Background::Then {
        const auto resources = loadWhatIsThere(state, {}, previous, progress);
        return [this, state, warnings, resources] {
            if (!resources)
                return refuse(resources.error());
            m_messages.set("opened", warnings);
            take(*resources);
            m_document.start(state, {});
        };
    });
}

void Assets::openInto(const QString& source)
{
    if ((m_document.file().isEmpty() && !m_document.isModified()) || isProjectFile(source.toStdString()))
        return openDocument(source);
    m_background.start([this, source, base = m_document.state(), previous = m_resources](const Progress& progress) -> Background::Then {
        const Loaded loaded = open(source.toStdString(), base, previous, progress);
        return [this, source, loaded] {
            if (loaded.error)
                return refuse(*loaded.error);
            m_messages.set("opened", loaded.opened.warnings);
            take(loaded.resources);
            m_document.edit(tr("Open %1").arg(QString::fromStdString(loaded.opened.state.name)), [&](State& state) {
                state.slots = loaded.opened.state.slots;
                state.name = loaded.opened.state.name;
                if (isBuiltInSource(source.toStdString())) // a sample brings its depth
                    state.parameters.depth = loaded.opened.state.parameters.depth;
            });
            if (!isBuiltInSource(source.toStdString()))
                addRecentFile(QFileInfo(source).absoluteFilePath());
        };
    });
}

void Assets::propose(const QString& text, std::function<void(State&)> change)
{
    State next = m_document.state();
    change(next);
    if (fits(next))
        return m_document.edit(text, change);
    m_background.start(
        [this, text, change, next, before = m_document.state(), previous = m_resources](const Progress& progress) -> Background::Then {
            const auto resources = loadResources(next, {}, previous, progress);
            return [this, text, change, next, before, resources] {
                if (!resources)
                    return refuse(resources.error());
                if (const auto error = newMapThatFailed(before, next, *resources->material))
                    return refuse(*error);
                take(*resources);
                m_document.edit(text, change);
            };
        });
}

void Assets::take(const Resources& resources)
{
    m_resources = resources;
    m_messages.clear("load");
    m_messages.set("maps", resources.material->warnings);
    m_messages.set("mesh", resources.mesh->warnings);
    Q_EMIT resourcesChanged();
}

// Undo, redo and pasted States name other files than those that are loaded.
void Assets::follow(Changes what)
{
    if (!what || !ready() || fits(m_document.state()))
        return;
    m_background.start([this, state = m_document.state(), previous = m_resources](const Progress& progress) -> Background::Then {
        const auto resources = loadWhatIsThere(state, {}, previous, progress);
        return [this, resources] {
            if (!fits(m_document.state())) // else it went back to what is loaded
                resources ? take(*resources) : refuse(resources.error());
        };
    });
}

void Assets::refuse(const Error& error)
{
    if (!cancelled(error))
        m_messages.set("load", error);
}

bool Assets::fits(const State& state) const
{
    return ready() && m_resources.material->slots == state.slots && m_resources.meshName == state.mesh
        && m_resources.environmentName == state.environment && boundsFit(state, m_resources);
}

} // namespace relievo
