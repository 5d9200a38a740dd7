// The web page: one file that needs no other, whose data are the State's, and which holds what it draws and no more.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/exporters/map_images.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/scene/source.h"
#include "core/state/techniques.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

using namespace relievo;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
std::vector<std::byte> decoded(const std::string& base64)
{
    const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::byte> bytes;
    unsigned group = 0, bits = 0;
    for (const char c : base64.substr(0, base64.find('='))) {
        group = group << 6 | unsigned(digits.find(c));
        if ((bits += 6) >= 8)
            bytes.push_back(std::byte(group >> (bits -= 8) & 255u));
    }
    return bytes;
}

class Web : public testing::Test {
protected:
    void SetUp() override
    {
        std::string name = (fs::temp_directory_path() / "relievo-web-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        open("sample:bricks@64");
    }
    void TearDown() override { fs::remove_all(m_folder); }
    void open(const std::string& source)
    {
        const Expected<Opened> opened = openSource(source, State());
        ASSERT_TRUE(opened);
        m_state = opened->state;
    }

    Expected<Exported> run(int size = 0)
    {
        const Expected<Resources> resources = loadResources(m_state, {}, {});
        EXPECT_TRUE(resources) << message(resources.error());
        m_resources = *resources;
        return findExport("web")->run({m_state, *resources, m_folder / "page.html", size, {}});
    }
    // The page's data; exports without an error.
    json data(int size = 0)
    {
        const Expected<Exported> exported = run(size);
        EXPECT_TRUE(exported) << message(exported.error());
        if (!exported)
            return {};
        m_warnings = exported->warnings;
        m_page = readText(exported->files.front()).value_or("");
        const std::string begin = "<script type=\"application/json\" id=\"data\">";
        const std::size_t from = m_page.find(begin) + begin.size();
        return json::parse(m_page.substr(from, m_page.find("</script>", from) - from), nullptr, false);
    }
    bool isTold(std::string_view code) const { return std::ranges::count(m_warnings, code, &Warning::code) > 0; }
    // Codes of 16 bits from their planes.
    std::vector<int> codes(const json& map)
    {
        const std::size_t channels = map["channels"], texels = map["width"].get<std::size_t>() * map["height"].get<std::size_t>();
        EXPECT_EQ(map["planes"].size(), 2 * channels);
        std::vector<int> codes(channels * texels);
        for (std::size_t plane = 0; plane < map["planes"].size(); ++plane) {
            const auto read = readImageBytes(decoded(map["planes"][plane]), "plane");
            EXPECT_TRUE(read && read->image.type == PixelType::U8 && read->image.texelCount() == texels);
            for (std::size_t i = 0; read && i < texels; ++i)
                codes[i * channels + plane / 2] += std::to_integer<int>(read->image.data[i * std::size_t(read->image.channels)])
                    << (plane % 2 == 0 ? 8 : 0);
        }
        return codes;
    }

    fs::path m_folder;
    State m_state;
    Resources m_resources;
    Warnings m_warnings;
    std::string m_page;
};

TEST_F(Web, IsOneSmallFileThatNeedsNoOther)
{
    open("sample:bricks@512");
    m_state.mesh = "sphere";
    const json page = data(512);
    ASSERT_TRUE(page.is_object());
    EXPECT_LT(m_page.size(), 4'000'000u);
    EXPECT_FALSE(isTold("web-large"));
    for (const char* reference : {"http:", "https:", "url(", "@import", "import(", "fetch(", "<link rel=\"stylesheet", "src=\""})
        EXPECT_EQ(m_page.find(reference), m_page.npos) << reference;
    EXPECT_EQ(m_page.find("{{"), m_page.npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), {}), 1);
    EXPECT_EQ(findExport("web")->writes({m_state, m_resources, m_folder / "page.html", 0, {}}).front(), m_folder / "page.html");
}

TEST_F(Web, TellsWhereAPageGrowsLarge)
{
    open("sample:terrain@1024");
    data();
    EXPECT_EQ(isTold("web-large"), m_page.size() > 4'000'000u);
    EXPECT_TRUE(isTold("web-large"));
}

TEST_F(Web, HoldsTheTextsOfBothTechniques)
{
    m_state.panes = {Pane{.technique = "relief"}, Pane{.technique = "cone-relaxed", .overrides = {{"leapSteps", 7}}}};
    const json page = data();
    ASSERT_EQ(page["sides"].size(), 2u);
    EXPECT_EQ(page["sides"][0]["label"], "Relief");
    EXPECT_EQ(page["sides"][1]["label"], "Relaxed cones");
    for (const json& side : page["sides"]) {
        EXPECT_TRUE(side["fragment"].get<std::string>().starts_with("#version 300 es"));
        EXPECT_NE(side["fragment"].get<std::string>().find("Hit trace(Ray ray)"), std::string::npos);
        EXPECT_TRUE(side["vertex"].get<std::string>().starts_with("#version 300 es"));
    }
    EXPECT_EQ(page["sides"][0]["uniforms"]["leapSteps"], Parameters().leapSteps);
    EXPECT_EQ(page["sides"][1]["uniforms"]["leapSteps"], 7);
    EXPECT_FALSE(page["sides"][0].contains("bound")); // relief reads none
    EXPECT_EQ(page["sides"][1]["bound"]["sampler"], "boundMap");
}

TEST_F(Web, ComparesOnePaneWithTheExactSearch)
{
    EXPECT_EQ(data()["sides"][1]["label"], "Cell cones");
    m_state.panes[0].technique = "cell-cone";
    EXPECT_EQ(data()["sides"][1]["label"], "Relief");
    m_state.slots = {};
    m_state.panes[0].technique = "bump";
    const json page = data();
    EXPECT_EQ(page["sides"][1]["label"], "Flat");
    EXPECT_FALSE(page.contains("height"));
    m_state.panes[0].technique = "relief";
    EXPECT_FALSE(run());
    open("sample:bricks@64");
    m_state.panes[0].technique = "reference";
    const Expected<Exported> exported = run();
    ASSERT_FALSE(exported);
    EXPECT_NE(message(exported.error()).find("reference"), std::string::npos);
}

TEST_F(Web, HeightsKeepSixteenBitsAndBoundsAreThoseOfTheWrittenHeights)
{
    for (const int size : {0, 32}) {
        const json page = data(size);
        const HeightField& field = *m_resources.material->height;
        const Image heights = reduced(heightImage(field, 16), size, Averaging::Plain);
        const std::vector<int> written = codes(page["height"]);
        ASSERT_EQ(written.size(), heights.texelCount());
        std::vector<float> values;
        for (std::size_t i = 0; i < written.size(); ++i) {
            EXPECT_EQ(written[i], std::lround(heights.value(int(i) % heights.width, int(i) / heights.width, 0) * 65535.f));
            values.push_back(float(written[i]) / 65535.f);
        }
        const auto bound = makeAccelerationMap("cell-cone", HeightField(heights.width, heights.height, values), m_state.parameters, false);
        ASSERT_TRUE(bound);
        const json& map = page["sides"][1]["bound"];
        EXPECT_EQ(map["sampler"], "cellMap");
        const std::vector<int> cells = codes(map);
        const Image& expected = (*bound)->levels.front();
        ASSERT_EQ(cells.size(), expected.texelCount() * 4);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            std::uint16_t code;
            std::memcpy(&code, expected.data.data() + 2 * i, 2);
            ASSERT_EQ(cells[i], code) << i;
        }
    }
}

TEST_F(Web, EveryTechniqueThatDrawsHasAPage)
{
    for (const TechniqueRow& technique : kTechniques) {
        if (technique.file.empty())
            continue;
        m_state.panes[0].technique = std::string(technique.key);
        const json page = data(16);
        ASSERT_TRUE(page.is_object()) << technique.key;
        EXPECT_EQ(page["sides"][0].contains("bound"), !technique.accelerationMap.empty()) << technique.key;
    }
}

TEST_F(Web, NamesCannotEndTheScript)
{
    m_state.name = "Old \"wall\" \\ \xc3\xbc </script><b>{{data}}{{title}}<!-- \xff";
    const json page = data();
    ASSERT_TRUE(page.is_object());
    EXPECT_EQ(page["name"], "Old \"wall\" \\ \xc3\xbc </script><b>{{data}}{{title}}<!-- \xef\xbf\xbd");
    std::size_t ends = 0;
    for (std::size_t at = m_page.find("</script>"); at != m_page.npos; at = m_page.find("</script>", at + 1))
        ++ends;
    EXPECT_EQ(ends, 2u); // of the data and of the code
    EXPECT_NE(m_page.find("<title>Old \"wall\" \\ \xc3\xbc &lt;/script>&lt;b>{{data}}{{title}}&lt;!--"), m_page.npos);
}

TEST_F(Web, HoldsTheMapsThatAreReadAlone)
{
    m_state.parameters.shading = Shading::MetallicRoughness;
    const json page = data();
    for (const MapKindRow& row : kMapKinds)
        if (row.kind != MapKind::Height) {
            const bool isRead = row.kind != MapKind::Specular && row.kind != MapKind::Gloss;
            EXPECT_EQ(page["maps"].contains(std::string(row.key)), m_resources.material->map(row.kind) && isRead) << row.key;
        }
    EXPECT_FALSE(page["background"].contains("fragment"));
    m_state.parameters.background = Backdrop::Gradient;
    EXPECT_TRUE(data()["background"].contains("fragment"));
}

TEST_F(Web, LeftOutThingsAreTold)
{
    data();
    EXPECT_FALSE(isTold("web-silhouettes") || isTold("web-object-shadows") || isTold("web-mesh"));
    m_state.parameters.silhouettes = Silhouettes::Prisms;
    m_state.parameters.objectShadows = true;
    data();
    EXPECT_TRUE(isTold("web-silhouettes"));
    EXPECT_TRUE(isTold("web-object-shadows"));
}

// Horizons are no texture of the page: its shadows are searched.
TEST_F(Web, HorizonsAreToldAndLeaveNoTrace)
{
    const json plain = data();
    EXPECT_FALSE(isTold("web-horizons"));
    m_state.parameters.shadowSearch = ShadowSearch::Horizon, m_state.parameters.ambientRelief = AmbientRelief::Bent;
    m_state.parameters.specularOcclusion = true;
    const json page = data();
    EXPECT_TRUE(isTold("web-horizons"));
    EXPECT_EQ(page["sides"][0]["fragment"], plain["sides"][0]["fragment"]);
}

// The page has the first light alone, as a directional one: the text is that of a State with no other.
TEST_F(Web, FurtherLightsAreToldAndLeaveNoTrace)
{
    const json plain = data();
    EXPECT_FALSE(isTold("web-lights"));
    m_state.parameters.light2Kind = LightKind::Point, m_state.parameters.light2Size = 3.f;
    const json page = data();
    EXPECT_TRUE(isTold("web-lights"));
    EXPECT_EQ(page["sides"][0]["fragment"], plain["sides"][0]["fragment"]);
    EXPECT_FALSE(page["sides"][0]["uniforms"].contains("lights"));
    m_state.parameters.lightKind = LightKind::Off;
    EXPECT_EQ(data()["sides"][0]["uniforms"]["lightIntensity"], 0.) << "dark, as the first light is off";
}

TEST_F(Web, PartsWithoutReliefStandLast)
{
    const json whole = data();
    EXPECT_EQ(decoded(whole["mesh"]["indices"]).size(), 2 * whole["mesh"]["relief"].get<std::size_t>());
    EXPECT_EQ(decoded(whole["mesh"]["positions"]).size(), m_resources.mesh->vertices.size() * 12);
    EXPECT_EQ(decoded(whole["environment"]["texels"]).size() % (6 * 4), 0u);
}

} // namespace
