// One stage of a program, put together from files and generated text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/program_text.h"
#include <optional>

namespace relievo {

// Collects the parts of a stage; each file is included once. The first file that cannot be read makes finish() fail.
class Assembly {
public:
    // forPeople: with comments, without #line.
    explicit Assembly(const ShaderReader& read, Dialect dialect = Dialect::Desktop, bool forPeople = false)
        : m_read(read)
        , m_dialect(dialect)
        , m_forPeople(forPeople)
    {
    }

    Assembly& file(std::string_view name);
    Assembly& generated(std::string_view text);
    Expected<std::string> body() const; // the parts alone
    Expected<ShaderText> finish(); // with the declarations that the parts need before them

private:
    void lines(const std::string& text, std::size_t index);

    const ShaderReader& m_read;
    Dialect m_dialect;
    bool m_forPeople;
    std::string m_body;
    std::vector<std::string> m_files = {"generated text"};
    std::optional<Error> m_failed;
};

} // namespace relievo
