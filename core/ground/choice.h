// Choices: enum classes whose words stand in one place, and arrays over them that cannot have another length.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>

namespace relievo {

// An enum class, numbered from 0, with wordOf(E): a switch without a default, so that the compiler asks for the word of a new value; ""
// for anything that is no value.
template <class E>
concept IsChoice = std::is_enum_v<E> && requires(E value)
{
    std::string_view(wordOf(value));
};

// How many values E has.
template <IsChoice E>
inline constexpr std::size_t kChoices = [] {
    std::size_t count = 0;
    while (!wordOf(E(count)).empty())
        ++count;
    return count;
}();

template <IsChoice E> constexpr std::optional<E> choiceOf(std::string_view word)
{
    for (std::size_t i = 0; i < kChoices<E>; ++i)
        if (wordOf(E(i)) == word)
            return E(i);
    return {};
}

// One T for each value of E.
template <IsChoice E, class T> struct PerChoice {
    std::array<T, kChoices<E>> values{};
    constexpr const T& operator[](E choice) const { return values[std::size_t(choice)]; }
    constexpr T& operator[](E choice) { return values[std::size_t(choice)]; }
};

// A set of values of an enum class with at most 32 of them.
template <class E> class EnumSet {
public:
    constexpr EnumSet() = default;
    constexpr EnumSet(std::initializer_list<E> values)
    {
        for (const E value : values)
            insert(value);
    }
    constexpr void insert(E value) { m_bits |= bit(value); }
    constexpr bool contains(E value) const { return (m_bits & bit(value)) != 0; }
    constexpr bool empty() const { return m_bits == 0; }
    constexpr auto operator<=>(const EnumSet&) const = default;

private:
    static constexpr unsigned bit(E value) { return 1u << unsigned(value); }
    unsigned m_bits = 0;
};

} // namespace relievo
