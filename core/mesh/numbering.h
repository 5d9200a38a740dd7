// Numbering values so that equal ones share a number.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relievo {

template <std::size_t N> using Bits = std::array<std::uint32_t, N>;

// The components of vectors one after the other; -0 is as 0.
template <class... Vectors> auto bitsOf(const Vectors&... vectors)
{
    Bits<(std::size_t(Vectors::length()) + ...)> bits{};
    std::size_t at = 0;
    const auto append = [&](const auto& vector) {
        for (int k = 0; k < vector.length(); ++k)
            bits[at++] = std::bit_cast<std::uint32_t>(vector[k] + 0.f);
    };
    (append(vectors), ...);
    return bits;
}

// Numbers from 0 in the order in which values first appear. A hash table without nodes: meshes ask it a million times.
template <std::size_t N> class Numbering {
public:
    struct Given {
        std::uint32_t number;
        bool isNew;
    };

    explicit Numbering(std::size_t expected)
    {
        m_keys.reserve(expected);
        m_slots.assign(std::bit_ceil(2 * expected + 16), 0);
    }

    Given operator()(const Bits<N>& key)
    {
        if (2 * m_keys.size() >= m_slots.size())
            grow();
        std::size_t at = start(key);
        for (; m_slots[at] != 0; at = (at + 1) & (m_slots.size() - 1))
            if (m_keys[m_slots[at] - 1] == key)
                return {m_slots[at] - 1, false};
        m_keys.push_back(key);
        m_slots[at] = std::uint32_t(m_keys.size());
        return {m_slots[at] - 1, true};
    }

    std::size_t size() const { return m_keys.size(); }

private:
    std::size_t start(const Bits<N>& key) const
    {
        std::uint64_t h = 0xcbf29ce484222325u;
        for (const std::uint32_t word : key) {
            h = (h ^ word) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return std::size_t(h) & (m_slots.size() - 1);
    }

    void grow()
    {
        m_slots.assign(2 * m_slots.size(), 0);
        for (std::size_t i = 0; i < m_keys.size(); ++i) {
            std::size_t at = start(m_keys[i]);
            while (m_slots[at] != 0)
                at = (at + 1) & (m_slots.size() - 1);
            m_slots[at] = std::uint32_t(i + 1);
        }
    }

    std::vector<Bits<N>> m_keys;
    std::vector<std::uint32_t> m_slots; // number + 1; 0: free
};

// The number of each vector of a list; equal vectors share theirs.
template <class Vector> std::vector<std::uint32_t> numbersOf(const std::vector<Vector>& list)
{
    Numbering<std::size_t(Vector::length())> numbering(list.size());
    std::vector<std::uint32_t> numbers;
    numbers.reserve(list.size());
    for (const Vector& vector : list)
        numbers.push_back(numbering(bitsOf(vector)).number);
    return numbers;
}

} // namespace relievo
