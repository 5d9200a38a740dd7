// Program text: includes, generated uniforms, and nothing that a State does not use.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/program_text.h"
#include "core/shader_text/shader_files.h"
#include "core/state/lights.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <gtest/gtest.h>

using namespace relievo;

namespace {
constexpr EnumSet<MapKind> kAll = {MapKind::Height, MapKind::Color, MapKind::Normal, MapKind::Roughness};
ProgramText textOf(const char* technique, const char* view, const Parameters& parameters = {}, EnumSet<MapKind> maps = kAll)
{
    auto text = meshProgram(programFeatures(parameters, *findTechnique(technique), *findView(view), maps, false), embeddedReader());
    EXPECT_TRUE(text) << message(text.error());
    return *text;
}
} // namespace

TEST(ProgramText, FlatHoldsNoSearch)
{
    const ProgramText text = textOf("flat", "shaded");
    EXPECT_EQ(text.fragment.text.find("for ("), std::string::npos);
    EXPECT_FALSE(text.fragment.mentions("heightMap"));
    EXPECT_FALSE(text.fragment.mentions("maxSteps"));
    EXPECT_FALSE(text.fragment.mentions("normalMap"));
}

TEST(ProgramText, OnlyWhatIsOn)
{
    Parameters parameters;
    EXPECT_TRUE(textOf("relief", "shaded", parameters).fragment.mentions("shadowBias"));
    parameters.shadows = false;
    EXPECT_FALSE(textOf("relief", "shaded", parameters).fragment.mentions("shadowBias"));
    EXPECT_FALSE(textOf("bump", "shaded").fragment.mentions("shadowBias"));
    EXPECT_FALSE(textOf("relief", "depth").fragment.mentions("colorMap"));
    EXPECT_FALSE(textOf("relief", "depth").fragment.mentions("environmentMap"));
    EXPECT_FALSE(textOf("relief", "shaded").fragment.mentions("exactDepth"));
    EXPECT_TRUE(textOf("relief", "error").fragment.mentions("exactDepth"));
    EXPECT_FALSE(textOf("relief", "shaded", {}, {MapKind::Height}).fragment.mentions("colorMap"));
}

TEST(ProgramText, LayersThatAreOffCostNothing)
{
    Parameters parameters;
    const std::string plain = textOf("relief", "shaded", parameters).fragment.text;
    for (const char* word : {"clearcoat", "sheen", "transmission", "opticsMap", "lookDirection", "anisotropyStrength", "lightSeen"})
        EXPECT_FALSE(mentionsIdentifier(plain, word)) << word;
    parameters.clearcoatRoughness = 0.5f, parameters.sheenRoughness = 1.f, parameters.anisotropyRotation = 40.f;
    parameters.bloomThreshold = 3.f, parameters.bloomSize = 0.4f;
    EXPECT_EQ(textOf("relief", "shaded", parameters).fragment.text, plain);
    parameters.clearcoat = 0.5f;
    const ProgramText coated = textOf("relief", "shaded", parameters);
    EXPECT_TRUE(coated.fragment.mentions("clearcoat"));
    EXPECT_FALSE(coated.fragment.mentions("sheenColor"));
    EXPECT_FALSE(coated.fragment.mentions("anisotropyStrength"));
    parameters.anisotropyStrength = 0.5f;
    EXPECT_TRUE(textOf("relief", "shaded", parameters).fragment.mentions("anisotropyStrength"));
    parameters.shading = Shading::BlinnPhong; // has no such layers
    EXPECT_FALSE(textOf("relief", "shaded", parameters).fragment.mentions("clearcoat"));
    EXPECT_EQ(textOf("relief", "depth", parameters).fragment.text, textOf("relief", "depth").fragment.text);
}

TEST(ProgramText, AGlowAlsoKeepsTheLightOfLitColorsAlone)
{
    Parameters glowing;
    glowing.bloom = 0.5f;
    EXPECT_TRUE(textOf("relief", "shaded", glowing).fragment.mentions("lightSeen"));
    for (const ViewRow& view : kViews)
        if (view.key != "shaded") {
            EXPECT_EQ(textOf("relief", view.key.data(), glowing).fragment.text, textOf("relief", view.key.data()).fragment.text)
                << view.key;
        }
    const ProgramFeatures exported = exportedFeatures(glowing, *findTechnique("relief"), kAll, Dialect::Es);
    EXPECT_FALSE(meshProgram(exported, embeddedReader())->fragment.mentions("lightSeen"));
}

// One directional light costs what it did before there were others: lights that are off, and all that they are set to, leave no trace.
TEST(ProgramText, LightsThatAreOffLeaveNoTrace)
{
    for (const char* view : {"shaded", "shadow", "invalid"})
        for (const char* technique : {"relief", "cell-cone", "flat"}) {
            const ShaderText plain = textOf(technique, view).fragment;
            EXPECT_FALSE(plain.mentions("lights") || plain.mentions("lightCount") || plain.mentions("lightAt")) << view;
            Parameters set;
            set.light2Intensity = 5.f, set.light3Size = 4.f, set.light4Shadows = false, set.lightDistance = 0.5f, set.lightTurn = 90.f;
            EXPECT_EQ(textOf(technique, view, set).fragment.text, plain.text) << view;
            set.light3Kind = LightKind::Point;
            const ShaderText several = textOf(technique, view, set).fragment;
            EXPECT_TRUE(several.mentions("lights")) << view;
            EXPECT_EQ(several.mentions("sampleTurn"), technique != std::string_view("flat")) << "it has a size";
        }
    Parameters several;
    several.lightKind = LightKind::Off, several.light2Kind = LightKind::Spot, several.light2Shadows = false;
    EXPECT_EQ(textOf("relief", "depth", several).fragment.text, textOf("relief", "depth").fragment.text);
    EXPECT_FALSE(textOf("relief", "shaded", several).fragment.mentions("shadowBias")) << "no light that is on asks for a search";
    several.light2Shadows = true;
    EXPECT_TRUE(textOf("relief", "shaded", several).fragment.mentions("shadowBias"));
}

// The relief's horizons are read by what asks for them, in place of a search, and nowhere else.
TEST(ProgramText, HorizonsThatAreNotReadLeaveNoTrace)
{
    for (const char* technique : {"relief", "cell-cone", "bump"})
        for (const char* view : {"shaded", "shadow"}) {
            const ShaderText plain = textOf(technique, view).fragment;
            EXPECT_FALSE(plain.mentions("horizonMap")) << view;
            Parameters set;
            set.horizonAzimuths = HorizonAzimuths::Eight, set.specularOcclusion = true;
            EXPECT_EQ(textOf(technique, view, set).fragment.text, plain.text) << view;
            set.shadowSearch = ShadowSearch::Horizon, set.shadows = false;
            EXPECT_FALSE(textOf(technique, view, set).fragment.mentions("horizonMap")) << "no light asks for shadows";
        }
    Parameters horizon;
    horizon.shadowSearch = ShadowSearch::Horizon;
    for (const LightKind second : {LightKind::Off, LightKind::Point})
        for (const float size : {0.f, 2.f}) {
            horizon.light2Kind = second, horizon.lightSize = size;
            const ShaderText text = textOf("relief", "shadow", horizon).fragment;
            EXPECT_TRUE(text.mentions("horizonMap"));
            EXPECT_FALSE(text.mentions("shadowBias") || text.mentions("lightIsHidden"));
        }
    EXPECT_FALSE(textOf("bump", "shaded", horizon).fragment.mentions("horizonMap")) << "it has no shadows";
    Parameters around;
    around.ambientRelief = AmbientRelief::Bent, around.specularOcclusion = true;
    EXPECT_TRUE(textOf("bump", "shaded", around).fragment.mentions("horizonMap"));
    EXPECT_EQ(textOf("relief", "shadow", around).fragment.text, textOf("relief", "shadow").fragment.text);
    for (const char* technique : {"flat", "as-bevy"})
        EXPECT_FALSE(textOf(technique, "shaded", around).fragment.mentions("horizonMap")) << technique;
    EXPECT_FALSE(textOf("bump", "shaded", around, {MapKind::Color}).fragment.mentions("horizonMap")) << "there are no heights";
}

TEST(ProgramText, ExactSearchesKnowWrapAndLevelBeforehand)
{
    Parameters parameters;
    parameters.heightMips = false;
    for (const char* key : {"pyramid", "cell-cone"}) {
        const auto repeats = textOf(key, "depth", parameters).fragment;
        EXPECT_FALSE(repeats.mentions("heightLevel")) << key;
        EXPECT_FALSE(repeats.mentions("wrap")) << key;
        EXPECT_TRUE(textOf(key, "depth").fragment.mentions("heightLevel")) << key;
        Parameters ending = parameters;
        ending.wrap = Wrap::Clamp;
        EXPECT_NE(textOf(key, "depth", ending).fragment.text, repeats.text) << key;
    }
    EXPECT_EQ(textOf("relief", "depth", parameters).fragment.text, textOf("relief", "depth").fragment.text);
}

TEST(ProgramText, UniformsComeFromTheTables)
{
    const std::string text = textOf("relief", "shaded").fragment.text;
    EXPECT_NE(text.find("uniform int maxSteps;"), std::string::npos);
    EXPECT_NE(text.find("uniform vec3 eye;"), std::string::npos);
    for (const ShaderFile& file : embeddedShaders())
        EXPECT_EQ(withoutComments(file.text).find("uniform"), std::string::npos) << file.name;
}

TEST(ProgramText, FilesAreIncludedOnce)
{
    const std::string text = textOf("relief", "error").fragment.text;
    const auto first = text.find("float exactDepth(");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.find("float exactDepth(", first + 1), std::string::npos);
}

TEST(ProgramText, CommonSubsetOfTheThreeMachines)
{
    // Technique texts also compile as C++: no swizzles, no literals without f, no ifdefs.
    for (const ShaderFile& file : embeddedShaders()) {
        if (!file.name.starts_with("techniques/"))
            continue;
        const std::string text = withoutComments(file.text);
        EXPECT_EQ(text.find("#if"), std::string::npos) << file.name;
        EXPECT_EQ(text.find(".xy"), std::string::npos) << file.name;
        EXPECT_EQ(text.find("layout"), std::string::npos) << file.name;
    }
}

TEST(ProgramText, LogsNameFileAndLine)
{
    const ShaderText text{"", {"generated text", "search/contract.glsl", "techniques/relief.glsl"}};
    EXPECT_EQ(namedLog("2:17(4): error: no such thing", text), "techniques/relief.glsl:17: error: no such thing");
    EXPECT_EQ(namedLog("ERROR: 1:3: x", text), "ERROR: search/contract.glsl:3: x");
    EXPECT_EQ(namedLog("1:3\n12:4(7", text), "search/contract.glsl:3\n12:4(7");
    for (const char* plain : {"", "1", "1:", "a: 17 (2)", "99999999999999999999:1", "1: 2"})
        EXPECT_EQ(namedLog(plain, text), plain);
}

TEST(ProgramText, MissingIncludeIsAnError)
{
    const ShaderReader reader = [](std::string_view name) -> Expected<std::string> {
        return name == "output/main.glsl" ? Expected<std::string>("#include \"gone.glsl\"\n") : embeddedReader()(name);
    };
    const auto text = meshProgram(programFeatures({}, knownTechnique("flat"), knownView("color"), {}, false), reader);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().where, "shaders/gone.glsl");
}

TEST(ProgramText, AMissingColorMapIsTheSameInShadersAndExports)
{
    EXPECT_EQ(kColorWithoutMapText, "vec3(" + std::to_string(kColorWithoutMap).substr(0, 3) + "f)");
}

TEST(ProgramText, CommentsAreBlankedIdentifiersFound)
{
    EXPECT_EQ(withoutComments("a // b\nc /* d\n */ e"), "a     \nc     \n    e");
    EXPECT_TRUE(mentionsIdentifier("x+depth;", "depth"));
    EXPECT_FALSE(mentionsIdentifier("hit.depth depths mydepth", "depth"));
}

TEST(ProgramText, EveryTechniqueAndViewAssembles)
{
    for (const TechniqueRow& technique : kTechniques)
        for (const ViewRow& view : kViews)
            for (const bool linear : {false, true}) {
                if (technique.file.empty())
                    continue;
                EXPECT_TRUE(meshProgram(programFeatures({}, technique, view, kAll, linear), embeddedReader()))
                    << technique.key << ' ' << view.key;
            }
}

// The text depends on no parameter but those whose rows say so; and each of those changes it for some technique and view.
TEST(ProgramText, DependsOnTheParametersThatSaySo)
{
    for (const ParameterRow& row : kParameters) {
        bool changes = false;
        for (const TechniqueRow& technique : kTechniques)
            for (const ViewRow& view : kViews) {
                Parameters base;
                base.silhouettes = Silhouettes::Quadric, base.objectShadows = true, base.shadows = true;
                base.ambientRelief = AmbientRelief::Occlusion; // without, nothing is taken from reflections either
                if (row.group > Group::Light && row.group <= Group::Light4) { // what such a light is, where it alone has shadows
                    base.shadows = false, base.light2Shadows = base.light3Shadows = base.light4Shadows = false;
                    for (const LightMembers& light : kLights)
                        if (kParameters[indexOf(light.kind)].group == row.group)
                            base.*light.kind = row.member == Member(light.kind) ? LightKind::Off : LightKind::Point,
                            base.*light.shadows = row.member != Member(light.shadows);
                }
                Parameters turned = base;
                set(turned, row, kindOf(row) == ValueKind::Switch ? Value(!std::get<bool>(get(base, row))) : Value(get(base, row)));
                if (kindOf(row) == ValueKind::Choice)
                    set(turned, row, std::get<int>(get(base, row)) == 0 ? 1 : 0);
                else if (kindOf(row) == ValueKind::Whole)
                    set(turned, row, std::get<int>(get(base, row)) + 1);
                else if (kindOf(row) == ValueKind::Number)
                    set(turned, row, std::get<float>(get(base, row)) == row.max ? row.min : row.max);
                else if (kindOf(row) == ValueKind::Color)
                    set(turned, row, Value(glm::vec3(row.min)));
                changes = changes
                    || programFeatures(base, technique, view, kAll, false) != programFeatures(turned, technique, view, kAll, false);
            }
        EXPECT_EQ(changes, row.affects.contains(Affects::ProgramText)) << row.key;
    }
}
