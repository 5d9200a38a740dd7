// Project files and presets read: JSON walked into a State.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/ground/json_depth.h"
#include "core/ground/shown_text.h"
#include "core/state/environments.h"
#include "core/state/sample_names.h"
#include "core/state/shapes.h"
#include "core/state/state_json.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;

namespace {

using FoundJson = nlohmann::json; // an ordered one compares each key with all before it
constexpr std::size_t kMostUnknownKeys = 10; // that are told one by one

// Walks a JSON text into a State; everything it cannot use becomes a warning with its place.
class Reader {
public:
    Reader(const fs::path& folder, const std::string& where) : m_folder(folder), m_where(where) { }
    Warnings warnings;

    void read(const FoundJson& json, State& state)
    {
        each(json, "", [&](const std::string& key, const FoundJson& value) {
            if (key == "relievo" || key == "panes")
                return true;
            if (key == "name")
                return text(value, key, state.name);
            if (key == "maps")
                return maps(value, state.slots);
            if (key == "parameters")
                return parameters(value, "parameters", [&](const ParameterRow& row, const Value& v) {
                    set(state.parameters, row, v);
                    for (Pane& pane : state.panes) // a preset's value wins over a pane's own; the file's panes come later
                        pane.overrides.erase(std::string(row.key));
                });
            if (key == "mesh")
                return file(value, key, state.mesh, !isBuiltInMesh(value.is_string() ? value.get<std::string>() : ""));
            if (key == "part")
                return text(value, key, state.part);
            if (key == "environment")
                return file(value, key, state.environment, !isBuiltInEnvironment(value.is_string() ? value.get<std::string>() : ""));
            if (key == "camera")
                return camera(value, key, state.camera);
            if (key == "view")
                return viewOfAll(value, key, state);
            return false;
        });
        if (json.contains("panes")) // after the parameters, which panes may override
            panes(json["panes"], state.panes);
        if (m_unknownKeys > kMostUnknownKeys)
            warnings.push_back(
                {"unknown-key", m_where + ": " + std::to_string(m_unknownKeys - kMostUnknownKeys) + " more unknown keys; ignored"});
    }

private:
    void warn(const std::string& code, const std::string& place, const std::string& what)
    {
        warnings.push_back({code, m_where + ": " + place + ": " + what});
    }

    static std::string placeOf(const std::string& place, const std::string& key)
    {
        return place.empty() ? shownName(key) : place + '.' + shownName(key);
    }

    // Calls take(key, value) for each member; false means that the key is unknown.
    template <class Take> bool each(const FoundJson& json, const std::string& place, Take take)
    {
        if (!json.is_object()) {
            warn("wrong-kind", place, "expected an object; ignored");
            return true;
        }
        for (const auto& [key, value] : json.items())
            if (!take(key, value) && ++m_unknownKeys <= kMostUnknownKeys)
                warn("unknown-key", placeOf(place, key), "unknown key; ignored");
        return true;
    }

    bool text(const FoundJson& value, const std::string& place, std::string& out)
    {
        if (value.is_string())
            out = value.get<std::string>();
        else
            warn("wrong-kind", place, "expected text; ignored");
        return true;
    }

    template <class Known> bool word(const FoundJson& value, const std::string& place, std::string& out, Known known)
    {
        std::string name = out;
        text(value, place, name);
        if (known(name))
            out = name;
        else
            warn("unknown-value", place, "there is no \"" + shownName(name) + "\"; ignored");
        return true;
    }

    // Files written by hand on Windows name folders with backslashes; a file may also be named with one.
    std::string withSlashes(std::string name) const
    {
        std::error_code code;
        if (name.find('\\') != name.npos && !fs::exists(m_folder / name, code))
            std::ranges::replace(name, '\\', '/');
        return name;
    }

    bool file(const FoundJson& value, const std::string& place, std::string& out, bool isPath)
    {
        std::string name = out;
        text(value, place, name);
        if (!value.is_string())
            return true;
        out = name.empty() || namesSample(name) || !isPath ? name : absolutePath(m_folder / withSlashes(name)).string();
        return true;
    }

    bool flag(const FoundJson& value, const std::string& place, bool& out)
    {
        if (value.is_boolean())
            out = value.get<bool>();
        else
            warn("wrong-kind", place, "expected true or false; ignored");
        return true;
    }

    bool slot(const FoundJson& json, const std::string& place, MapSlot& out)
    {
        return each(json, place, [&](const std::string& key, const FoundJson& value) {
            if (key == "file")
                return file(value, place + ".file", out.file, true);
            if (key == "invert")
                return flag(value, place + ".invert", out.invert);
            if (key != "channel")
                return false;
            std::string name(wordOf(out.channel));
            word(value, place + ".channel", name, [](const std::string& n) { return choiceOf<Channel>(n).has_value(); });
            out.channel = *choiceOf<Channel>(name);
            return true;
        });
    }

    // A file that lists maps names them all: slots it does not mention are empty.
    bool maps(const FoundJson& json, MapSlots& slots)
    {
        slots = {};
        return each(json, "maps", [&](const std::string& key, const FoundJson& value) {
            const auto kind = findMapKind(key);
            return kind && slot(value, "maps." + key, slots[std::size_t(*kind)]);
        });
    }

    std::optional<Value> value(const ParameterRow& row, const FoundJson& json)
    {
        if (json.is_string())
            return parseValue(row, json.get<std::string>());
        const ValueKind kind = kindOf(row);
        if (json.is_boolean() && kind == ValueKind::Switch)
            return json.get<bool>();
        if (json.is_number() && kind == ValueKind::Number)
            return json.get<float>();
        if (json.is_number() && (kind == ValueKind::Whole || kind == ValueKind::Choice)
            && json.get<double>() == std::round(json.get<double>()))
            return int(std::clamp(std::round(json.get<double>()), -2e9, 2e9));
        if (json.is_array() && json.size() == 3 && kind == ValueKind::Color
            && std::ranges::all_of(json, [](const FoundJson& j) { return j.is_number(); }))
            return glm::vec3(json[0].get<float>(), json[1].get<float>(), json[2].get<float>());
        return {};
    }

    template <class Take> bool parameters(const FoundJson& json, const std::string& place, Take take)
    {
        return each(json, place, [&](const std::string& key, const FoundJson& j) {
            const ParameterRow* row = findParameter(key);
            if (!row)
                return false;
            const auto read = value(*row, j);
            if (!read) {
                warn("wrong-kind", place + '.' + key, "not a value of this parameter; ignored");
                return true;
            }
            const Value kept = clamped(*row, *read);
            if (kept != *read)
                warn("out-of-range", place + '.' + key, toText(*row, *read) + " is out of range; " + toText(*row, kept) + " is used");
            take(*row, kept);
            return true;
        });
    }

    bool camera(const FoundJson& json, const std::string& place, Camera& out)
    {
        return each(json, place, [&](const std::string& key, const FoundJson& value) {
            if (key != "yaw" && key != "pitch" && key != "fov" && key != "distance" && key != "target" && key != "fill")
                return false;
            const auto isNumber = [](const FoundJson& one) { return one.is_number(); };
            const bool isPoint = key == "target" && value.is_array() && value.size() == 3 && std::ranges::all_of(value, isNumber);
            if (!isPoint && !isNumber(value)) { // lists may be nested deeper than dump() can follow
                warn("wrong-kind", place + '.' + key,
                    "expected " + std::string(key == "target" ? "three numbers" : "a number") + "; ignored");
                return true;
            }
            const std::string text = isPoint ? value[0].dump() + ':' + value[1].dump() + ':' + value[2].dump() : value.dump();
            if (!setCamera(out, key + '=' + text))
                warn("out-of-range", place + '.' + key, text + " cannot be used; ignored");
            return true;
        });
    }

    static bool isView(const std::string& name) { return findView(name) != nullptr; }

    // A view beside the panes is that of all panes that do not name one.
    bool viewOfAll(const FoundJson& value, const std::string& place, State& state)
    {
        std::string view = state.panes.front().view;
        word(value, place, view, isView);
        setView(state, view);
        return true;
    }

    bool ownCamera(const FoundJson& json, const std::string& place, std::optional<Camera>& out)
    {
        Camera own;
        camera(json, place, own);
        if (json.is_object())
            out = own;
        return true;
    }

    bool panes(const FoundJson& json, std::vector<Pane>& out)
    {
        const std::string most = std::to_string(kMaxPanes);
        if (!json.is_array() || json.empty()) {
            warn("wrong-kind", "panes", "expected a list of 1 to " + most + " panes; ignored");
            return true;
        }
        if (json.size() > kMaxPanes)
            warn("out-of-range", "panes", "only the first " + most + " panes are used");
        Pane further;
        further.view = out.front().view;
        out.resize(std::min(json.size(), kMaxPanes), further);
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i].camera.reset(); // linked, unless the file says otherwise
            pane(json[i], "panes[" + std::to_string(i) + ']', out[i]);
        }
        return true;
    }

    void pane(const FoundJson& json, const std::string& place, Pane& out)
    {
        each(json, place, [&](const std::string& key, const FoundJson& value) {
            if (key == "technique")
                return word(
                    value, place + ".technique", out.technique, [](const std::string& name) { return findTechnique(name) != nullptr; });
            if (key == "view")
                return word(value, place + ".view", out.view, isView);
            if (key == "camera")
                return ownCamera(value, place + ".camera", out.camera);
            if (key != "overrides")
                return false;
            out.overrides.clear();
            return parameters(
                value, place + ".overrides", [&](const ParameterRow& row, const Value& v) { out.overrides[std::string(row.key)] = v; });
        });
    }

    const fs::path& m_folder;
    const std::string& m_where;
    std::size_t m_unknownKeys = 0;
};

} // namespace

Expected<StateRead> fromJson(const State& base, const std::string& text, const fs::path& folder, const std::string& where)
{
    if (isNestedTooDeep(text))
        return failure(
            where, "this is not a Relievo project or preset (its JSON is nested too deeply)", "Choose a file that Relievo has saved");
    const FoundJson json = FoundJson::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object())
        return failure(where, "this is not a Relievo project or preset (no valid JSON object)", "Choose a file that Relievo has saved");
    const auto version = json.find("relievo");
    if (version == json.end() || !version->is_number_integer())
        return failure(
            where, "this is not a Relievo project or preset (no \"relievo\" version number)", "Choose a file that Relievo has saved");
    if (!version->is_number_unsigned() || version->get<std::uint64_t>() < 1)
        return failure(where, "there is no version " + version->dump() + " of Relievo's files", "Choose a file that Relievo has saved");
    if (version->get<std::uint64_t>() > std::uint64_t(kStateVersion))
        return failure(where, "the file was saved by a newer Relievo (version " + version->dump() + ')', "Open it with a newer Relievo");
    StateRead result{base, {}};
    Reader reader(folder, where);
    reader.read(json, result.state);
    result.warnings = std::move(reader.warnings);
    return result;
}

Expected<StateRead> readState(const State& base, const fs::path& file)
{
    const auto text = readText(file, std::size_t(64) << 20);
    if (!text)
        return tl::unexpected(text.error());
    return fromJson(base, *text, absolutePath(file).parent_path(), file.string());
}

} // namespace relievo
