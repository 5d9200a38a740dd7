// Translating: glslang makes SPIR-V, SPIRV-Cross the other language, and what the search needs is put together at the top.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/translate.h"
#include "core/shader_text/program_text.h"
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <memory>
#include <regex>
#include <set>
#include <spirv_cross/spirv_cross_c.h>
#include <sstream>

namespace relievo {
namespace {

constexpr const char* kBlock = "Relief"; // of all uniforms
constexpr int kGlslVersion = 410;
constexpr unsigned kShaderModel = 50;

tl::unexpected<Error> untranslatable(const std::string& log)
{
    return failure(
        "the exported shader", "cannot be translated: " + log.substr(0, log.find("\n\n")), "Please report this as a fault of Relievo");
}

Expected<std::vector<unsigned>> spirvOf(const std::string& glsl, Stage stage)
{
    static const bool started = glslang::InitializeProcess(); // kept: it is made anew at every use otherwise
    const EShLanguage language = stage == Stage::Vertex ? EShLangVertex : EShLangFragment;
    const EShMessages rules = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(language);
    const char* text = glsl.c_str();
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvInputVulkanRulesRelaxed(); // uniforms outside of blocks
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    shader.setGlobalUniformBlockName(kBlock);
    shader.setAutoMapBindings(true);
    shader.setAutoMapLocations(true);
    if (!started || !shader.parse(GetDefaultResources(), kGlslVersion, false, rules))
        return untranslatable(shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(rules) || !program.mapIO())
        return untranslatable(program.getInfoLog());
    std::vector<unsigned> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(language), spirv);
    return spirv;
}

void nameAndSetUp(spvc_compiler compiler, Stage stage, ShadingLanguage language)
{
    spvc_resources resources = nullptr;
    const spvc_reflected_resource* buffers = nullptr;
    std::size_t count = 0;
    spvc_compiler_create_shader_resources(compiler, &resources);
    spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, &buffers, &count);
    for (std::size_t i = 0; i < count; ++i)
        spvc_compiler_set_name(compiler, buffers[i].id, "u");
    spvc_compiler_options options = nullptr;
    spvc_compiler_create_compiler_options(compiler, &options);
    if (language == ShadingLanguage::Hlsl) {
        spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, kShaderModel);
    } else {
        spvc_compiler_msl_set_combined_sampler_suffix(compiler, "Sampler");
        spvc_compiler_rename_entry_point(compiler, "main", stage == Stage::Vertex ? "relief_vertex" : "relief_fragment",
            stage == Stage::Vertex ? SpvExecutionModelVertex : SpvExecutionModelFragment);
    }
    spvc_compiler_install_compiler_options(compiler, options);
}

Expected<std::string> crossed(const std::vector<unsigned>& spirv, Stage stage, ShadingLanguage language)
{
    spvc_context made = nullptr;
    if (spvc_context_create(&made) != SPVC_SUCCESS)
        return untranslatable("no memory");
    const std::unique_ptr<spvc_context_s, decltype(&spvc_context_destroy)> context(made, &spvc_context_destroy);
    spvc_parsed_ir parsed = nullptr;
    spvc_compiler compiler = nullptr;
    const char* text = nullptr;
    const spvc_backend backend = language == ShadingLanguage::Hlsl ? SPVC_BACKEND_HLSL : SPVC_BACKEND_MSL;
    if (spvc_context_parse_spirv(made, spirv.data(), spirv.size(), &parsed) != SPVC_SUCCESS
        || spvc_context_create_compiler(made, backend, parsed, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) != SPVC_SUCCESS)
        return untranslatable(spvc_context_get_last_error_string(made));
    nameAndSetUp(compiler, stage, language);
    if (spvc_compiler_compile(compiler, &text) != SPVC_SUCCESS)
        return untranslatable(spvc_context_get_last_error_string(made));
    return std::regex_replace(std::string(text), std::regex("\\b_(\\w+)_sampler\\b"), "$1Sampler");
}

// A function, a struct, a variable, or a line of the preprocessor, as it stands outside of all braces.
struct Piece {
    std::string text, name;
};

std::string nameOf(const std::string& text)
{
    static const std::regex type(R"(^\s*(?:struct|cbuffer)\s+(\w+))"), attribute(R"(__attribute__\(\(\w+\)\)|template<[^\n]*>)"),
        before(R"((\w+)\s*(?:\[[^\]]*\]\s*)?[(;=:])");
    std::smatch found;
    if (text.starts_with('#') || text.starts_with("using "))
        return {};
    if (std::regex_search(text, found, type))
        return found[1];
    const std::string head = std::regex_replace(text.substr(0, text.find('{')), attribute, "");
    return std::regex_search(head, found, before) ? std::string(found[1]) : std::string();
}

std::vector<Piece> piecesOf(const std::string& text)
{
    std::vector<Piece> pieces;
    std::istringstream lines(text);
    std::string piece;
    int depth = 0;
    for (std::string line; std::getline(lines, line);) {
        if (piece.empty() && line.empty())
            continue;
        piece += line + '\n';
        for (const char c : line)
            depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (depth == 0 && (line.starts_with('#') || line.ends_with(';') || line.ends_with('}'))) {
            pieces.push_back({piece, nameOf(piece)});
            piece.clear();
        }
    }
    return pieces;
}

// The buffer of uniforms, textures and samplers: what is given from outside.
bool isGiven(const Piece& piece)
{
    return piece.name == kBlock || piece.text.starts_with("Texture") || piece.text.starts_with("SamplerState");
}

// Names of `trace` and of all that it comes to need.
std::set<std::string> neededBySearch(const std::vector<Piece>& pieces)
{
    std::set<std::string> needed = {"trace"};
    for (std::size_t before = 0; before != needed.size();) {
        before = needed.size();
        for (const Piece& piece : pieces)
            if (needed.contains(piece.name))
                for (const Piece& other : pieces)
                    if (!other.name.empty() && !isGiven(other) && mentionsIdentifier(piece.text, other.name))
                        needed.insert(other.name);
    }
    return needed;
}

std::string withSearchMarked(const std::string& text)
{
    const std::vector<Piece> pieces = piecesOf(text);
    const std::set<std::string> needed = neededBySearch(pieces);
    std::string given, search, rest;
    for (const Piece& piece : pieces) {
        const bool isHead = piece.name.empty() || isGiven(piece);
        const bool isLine = std::ranges::count(piece.text, '\n') == 1;
        (isHead ? given : needed.contains(piece.name) ? search : rest) += piece.text + (isLine ? "" : "\n");
    }
    return given + '\n' + std::string(kTechniqueBegins) + '\n' + search + std::string(kTechniqueEnds) + '\n' + rest;
}
} // namespace

Expected<std::string> translated(const std::string& glsl, Stage stage, ShadingLanguage language)
{
    const auto spirv = spirvOf(glsl, stage);
    if (!spirv)
        return tl::unexpected(spirv.error());
    Expected<std::string> text = crossed(*spirv, stage, language);
    return text && mentionsIdentifier(glsl, "trace") ? withSearchMarked(*text) : text;
}

namespace {
// A struct inside of a function has no static members: constants of structs stand where variables begin with them.
std::string withoutStatics(std::string hlsl)
{
    static const std::regex constant(R"(\nstatic const \w+ (\w+) = (\{[^;\n]*\});)");
    for (std::smatch found; std::regex_search(hlsl, found, constant);) {
        const std::string name = found[1], value = found[2];
        hlsl = std::regex_replace(found.prefix().str() + found.suffix().str(), std::regex("= " + name + ";"), "= " + value + ";");
    }
    return hlsl;
}
} // namespace

Expected<std::string> searchAsStruct(const std::string& glsl)
{
    const auto spirv = spirvOf(glsl, Stage::Fragment);
    if (!spirv)
        return tl::unexpected(spirv.error());
    const Expected<std::string> text = crossed(*spirv, Stage::Fragment, ShadingLanguage::Hlsl);
    if (!text)
        return text;
    const std::vector<Piece> pieces = piecesOf(withoutStatics(*text));
    const std::set<std::string> needed = neededBySearch(pieces);
    std::string structs, members, functions, set;
    for (const Piece& piece : pieces) {
        if (piece.text.starts_with("cbuffer"))
            return untranslatable("it has uniforms");
        if (isGiven(piece)) {
            members += std::regex_replace(piece.text, std::regex(" : register\\(\\w+\\)"), "");
            set += "relief." + piece.name + " = " + piece.name + ";\n";
        } else if (needed.contains(piece.name)) {
            (piece.text.starts_with("struct ") ? structs : functions) += piece.text + '\n';
        }
    }
    return structs + "struct " + kBlock + "\n{\n" + members + '\n' + functions + "};\n" + kBlock + " relief;\n" + set;
}

} // namespace relievo
