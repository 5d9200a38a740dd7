// Reading shader files, finding what they mention, and putting them together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/assembly.h"
#include "core/ground/file.h"
#include "core/shader_text/shader_files.h"
#include <algorithm>

namespace relievo {

std::string withoutComments(std::string_view text)
{
    std::string out(text);
    enum { Code, Line, Block } in = Code;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const bool pair = i + 1 < text.size();
        if (in == Code && pair && text[i] == '/' && (text[i + 1] == '/' || text[i + 1] == '*')) {
            in = text[i + 1] == '/' ? Line : Block;
            out[i] = out[i + 1] = ' ';
            ++i;
        } else if (in == Line && text[i] == '\n') {
            in = Code;
        } else if (in == Block && pair && text[i] == '*' && text[i + 1] == '/') {
            in = Code;
            out[i] = out[i + 1] = ' ';
            ++i;
        } else if (in != Code && text[i] != '\n') {
            out[i] = ' ';
        }
    }
    return out;
}

bool ShaderText::mentions(std::string_view identifier) const
{
    return mentionsIdentifier(text, identifier);
}

ShaderReader embeddedReader()
{
    return [](std::string_view name) -> Expected<std::string> {
        const auto& files = embeddedShaders();
        const auto found = std::ranges::find(files, name, &ShaderFile::name);
        if (found == files.end())
            return failure(ErrorCode::NotFound, "shaders/" + std::string(name), "there is no such shader file", "Check the #include line");
        return std::string(found->text);
    };
}

ShaderReader folderReader(const std::filesystem::path& folder)
{
    return [folder](std::string_view name) -> Expected<std::string> {
        std::error_code code;
        if (std::filesystem::exists(folder / name, code))
            return readText(folder / name);
        return embeddedReader()(name);
    };
}

namespace {

// By Dialect.
constexpr std::array<std::string_view, 2> kHeaders = {"#version 410 core\n#extension GL_ARB_conservative_depth : enable\n",
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler3D;\n"
    "precision highp usampler2D;\n"};

// Techniques say which steps they take in lines that only the CPU has (core/trace/recorded_steps.h).
bool isRecord(std::string_view line)
{
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    return line.starts_with("record") && line.ends_with(");") && line.find('(') <= std::string_view("recordHalving").size();
}
} // namespace

Assembly& Assembly::file(std::string_view name)
{
    if (m_failed || std::ranges::count(m_files, name))
        return *this;
    const auto text = m_read(name);
    if (!text) {
        m_failed = text.error();
        return *this;
    }
    m_files.emplace_back(name);
    lines(m_forPeople ? *text : withoutComments(*text), m_files.size() - 1);
    return *this;
}

Assembly& Assembly::generated(std::string_view text)
{
    if (!m_forPeople)
        m_body += "#line 1 0\n";
    m_body += text;
    m_body += '\n';
    return *this;
}

Expected<std::string> Assembly::body() const
{
    if (m_failed)
        return tl::unexpected(*m_failed);
    return m_body;
}

Expected<ShaderText> Assembly::finish()
{
    if (m_failed)
        return tl::unexpected(*m_failed);
    return ShaderText{
        std::string(kHeaders[std::size_t(m_dialect)]) + uniformDeclarations(m_forPeople ? withoutComments(m_body) : m_body) + m_body,
        m_files};
}

void Assembly::lines(const std::string& text, std::size_t index)
{
    const std::string number = std::to_string(index);
    if (!m_forPeople)
        m_body += "#line 1 " + number + '\n';
    std::size_t line = 1;
    for (std::size_t at = 0; at < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view content = std::string_view(text).substr(at, end - at);
        if (content.starts_with("#include")) {
            const std::size_t open = content.find('"'), close = content.rfind('"');
            if (open < close && close != content.npos)
                file(content.substr(open + 1, close - open - 1));
            if (!m_forPeople)
                m_body += "#line " + std::to_string(line + 1) + ' ' + number + '\n';
        } else if (!m_forPeople && isRecord(content)) {
            m_body += '\n';
        } else if (!m_forPeople || (!content.starts_with("// SPDX-") && !isRecord(content))) { // the former stands once, at the head
            m_body.append(content);
            m_body += '\n';
        }
        at = end + 1;
    }
}

} // namespace relievo
