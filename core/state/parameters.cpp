// Reading, writing and checking parameters through their table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/parameters.h"
#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace relievo {

const ParameterRow* findParameter(std::string_view key)
{
    const auto found = std::ranges::find(kParameters, key, &ParameterRow::key);
    return found == kParameters.end() ? nullptr : &*found;
}

std::optional<int> findOption(const ParameterRow& row, std::string_view word)
{
    for (int i = 0; i < optionCount(row); ++i)
        if (option(row, i) == word)
            return i;
    return {};
}

std::string optionList(const ParameterRow& row, char separator)
{
    std::string list;
    for (int i = 0; i < optionCount(row); ++i)
        list += (i == 0 ? std::string() : std::string(1, separator)) + std::string(option(row, i));
    return list;
}

namespace {
// What a Value holds for a member of type T.
template <class T> struct Held {
    using Type = T;
};
template <IsChoice T> struct Held<T> {
    using Type = int;
};
} // namespace

bool isOfKind(const ParameterRow& row, const Value& value)
{
    return get(Parameters{}, row).index() == value.index();
}

Value get(const Parameters& parameters, const ParameterRow& row)
{
    return std::visit(
        [&](auto member) -> Value { return typename Held<MemberType<decltype(member)>>::Type(parameters.*member); }, row.member);
}

void set(Parameters& parameters, const ParameterRow& row, const Value& value)
{
    assert(isOfKind(row, value));
    std::visit(
        [&](auto member) {
            using T = MemberType<decltype(member)>;
            if (const auto* same = std::get_if<typename Held<T>::Type>(&value))
                parameters.*member = T(*same);
        },
        row.member);
}

std::size_t variantOf(const ParameterRow& row, const Value& value)
{
    if (const int* number = std::get_if<int>(&value))
        return kindOf(row) == ValueKind::Choice ? std::size_t(*number) : std::size_t(*number > 0);
    if (const float* number = std::get_if<float>(&value))
        return *number > 0.f ? 1 : 0;
    const bool* on = std::get_if<bool>(&value);
    return on && *on ? 1 : 0;
}

std::string keysOf(const ParameterSet& set)
{
    std::string keys;
    for (const ParameterRow& row : kParameters)
        if (set.contains(row))
            keys += (keys.empty() ? "" : " ") + std::string(row.key);
    return keys;
}

Parameters onlyAffecting(Affects what, const Parameters& parameters)
{
    Parameters only;
    for (const ParameterRow& row : kParameters)
        if (row.affects.contains(what))
            set(only, row, get(parameters, row));
    return only;
}

namespace {
float clampedNumber(const ParameterRow& row, float v)
{
    return v >= row.min ? std::min(v, row.max) : row.min;
} // NaN: the minimum
} // namespace

Value clamped(const ParameterRow& row, const Value& value)
{
    if (const float* f = std::get_if<float>(&value))
        return clampedNumber(row, *f);
    if (const int* i = std::get_if<int>(&value))
        return std::clamp(*i, int(row.min), int(row.max));
    if (const glm::vec3* c = std::get_if<glm::vec3>(&value))
        return glm::vec3(clampedNumber(row, c->x), clampedNumber(row, c->y), clampedNumber(row, c->z));
    return value;
}

bool inRange(const ParameterRow& row, const Value& value)
{
    return clamped(row, value) == value;
}

namespace {
template <class T> std::optional<T> parseNumber(std::string_view text)
{
    T value{};
    if (text.starts_with('+'))
        text.remove_prefix(1);
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size())
        return {};
    return value;
}

std::optional<Value> parseColor(std::string_view text)
{
    if (text.size() == 7 && text[0] == '#') { // the numbers as they are: linear, not sRGB
        unsigned rgb = 0;
        const auto [end, code] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
        if (code != std::errc() || end != text.data() + 7)
            return {};
        return glm::vec3(float(rgb >> 16), float((rgb >> 8) & 255u), float(rgb & 255u)) / 255.f;
    }
    glm::vec3 color;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = i < 2 ? text.find(',') : text.size();
        if (comma == text.npos)
            return {};
        const auto number = parseNumber<float>(text.substr(0, comma));
        if (!number)
            return {};
        color[i] = *number;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return color;
}

std::optional<Value> parseBool(std::string_view text)
{
    if (text == "true" || text == "on" || text == "yes" || text == "1")
        return true;
    if (text == "false" || text == "off" || text == "no" || text == "0")
        return false;
    return {};
}

std::optional<Value> parseOption(const ParameterRow& row, std::string_view text)
{
    if (const auto choice = findOption(row, text))
        return *choice;
    if (const auto number = parseNumber<int>(text))
        return *number;
    return {};
}
} // namespace

std::optional<Value> parseValue(const ParameterRow& row, std::string_view text)
{
    switch (kindOf(row)) {
    case ValueKind::Number:
        if (const auto number = parseNumber<float>(text))
            return *number;
        return {};
    case ValueKind::Whole:
        if (const auto number = parseNumber<int>(text))
            return *number;
        return {};
    case ValueKind::Switch:
        return parseBool(text);
    case ValueKind::Color:
        return parseColor(text);
    case ValueKind::Choice:
        return parseOption(row, text);
    }
    return {};
}

namespace {
std::string numberText(float value)
{
    char buffer[32];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr); // shortest that reads back
}
} // namespace

std::string toText(const ParameterRow& row, const Value& value)
{
    if (const float* f = std::get_if<float>(&value))
        return numberText(*f);
    if (const int* i = std::get_if<int>(&value))
        return kindOf(row) == ValueKind::Choice ? std::string(option(row, *i)) : std::to_string(*i);
    if (const bool* b = std::get_if<bool>(&value))
        return *b ? "true" : "false";
    const glm::vec3 c = std::get<glm::vec3>(value);
    return numberText(c.x) + ',' + numberText(c.y) + ',' + numberText(c.z);
}

} // namespace relievo
