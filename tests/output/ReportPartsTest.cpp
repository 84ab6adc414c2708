#include "output/report/Escape.h"
#include "output/report/GraphLayout.h"
#include "output/report/Template.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

namespace limen::output {
namespace {

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Escape, textCannotLeaveAnElementOrAnAttribute) {
    EXPECT_EQ(escapeHtml("<b a=\"1\" c='2'>&amp;</b>"),
              "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
    EXPECT_EQ(escapeHtml("caf\xC3\xA9\n\t1"), "caf\xC3\xA9\n\t1");
    EXPECT_EQ(escapeHtml(std::string_view("a\0b\x1B", 4)), "a\xEF\xBF\xBD"
                                                           "b\xEF\xBF\xBD");
}

TEST(Escape, jsonCannotEndItsScript) {
    const std::string text = nlohmann::json("</script><!--").dump();
    const std::string escaped = escapeScriptJson(text);
    EXPECT_EQ(escaped.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(escaped), nlohmann::json::parse(text)) << "the same value";
}

// The vectors of RFC 4648, section 10.
TEST(Escape, base64FollowsTheStandard) {
    const std::pair<const char*, const char*> vectors[] = {
        {"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
        {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, encoded] : vectors)
        EXPECT_EQ(base64(bytesOf(text)), encoded);
    EXPECT_EQ(base64(bytesOf("\xFF\xFE\xFB")), "//77");
    EXPECT_EQ(dataUri("image/png", bytesOf("f")), "data:image/png;base64,Zg==");
}

TEST(Template, fillsVariablesAndSections) {
    const nlohmann::ordered_json values = {{"name", "<a>"},
                                           {"count", 3},
                                           {"yes", true},
                                           {"no", false},
                                           {"empty", nlohmann::ordered_json::array()},
                                           {"text", ""},
                                           {"nothing", nullptr},
                                           {"words", {"x", "y"}},
                                           {"rows", {{{"cell", 1}, {"name", "inner"}}, {{"cell", 2}}}},
                                           {"object", {{"cell", 7}}}};
    EXPECT_EQ(fillTemplate("{{name}} {{{name}}} {{count}}", values), "&lt;a&gt; <a> 3");
    EXPECT_EQ(fillTemplate("{{#rows}}[{{cell}} {{name}}]{{/rows}}", values), "[1 inner][2 &lt;a&gt;]");
    EXPECT_EQ(fillTemplate("{{#words}}{{.}},{{/words}}", values), "x,y,");
    EXPECT_EQ(fillTemplate("{{#yes}}a{{/yes}}{{#no}}b{{/no}}{{^no}}c{{/no}}", values), "ac");
    EXPECT_EQ(fillTemplate("{{^empty}}none{{/empty}}{{#empty}}some{{/empty}}{{#text}}t{{/text}}", values),
              "none");
    EXPECT_EQ(fillTemplate("{{#nothing}}{{unknown}}{{/nothing}}{{#object}}{{cell}}{{/object}}", values), "7");
}

TEST(TemplateDeathTest, anUnknownNameIsAFaultOfTheTemplate) {
    EXPECT_DEATH((void)fillTemplate("{{unknown}}", nlohmann::ordered_json::object()), "known names");
    EXPECT_DEATH((void)fillTemplate("{{#a}}", {{"a", true}}), "nested");
}

double closestPair(const std::vector<Vec2>& points) {
    double closest = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            closest = std::min(closest, glm::length(points[i] - points[j]));
    return closest;
}

TEST(GraphLayout, joinedNodesAreNearAndOthersApart) {
    // A chain of ten, all at one position: as cells above each other.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i + 1 < 10; ++i)
        edges.emplace_back(i, i + 1);
    const std::vector<Vec2> points = layOutGraph(std::vector<Vec2>(10, Vec2(5.0, 5.0)), edges);
    for (const auto& [a, b] : edges)
        EXPECT_LT(glm::length(points[a] - points[b]), 2.5);
    EXPECT_GT(glm::length(points[0] - points[9]), 3.0);
    EXPECT_GT(closestPair(points), 0.3);
}

TEST(GraphLayout, threeHundredNodesStayApart) {
    std::vector<Vec2> start;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i < 300; ++i) {
        start.emplace_back(32000.0 + i % 20 * 7.0, 34000.0 + i / 20 * 7.0);
        if (i % 20 != 0)
            edges.emplace_back(i - 1, i);
        if (i >= 20 && i % 5 == 0)
            edges.emplace_back(i - 20, i);
        if (i % 40 == 0 && i > 0)
            edges.emplace_back(0, i); // a hub, as the outside is
    }
    const std::vector<Vec2> points = layOutGraph(start, edges);
    EXPECT_GT(closestPair(points), 0.2);
    EXPECT_EQ(points, layOutGraph(start, edges)) << "the same input gives the same result";
    EXPECT_LT(points[0].x, points[19].x) << "east stays east";
}

RC_GTEST_PROP(GraphLayoutProperty, anyGraphGivesFinitePositions, ()) {
    const auto count = *rc::gen::inRange<std::uint32_t>(1, 25);
    const auto node = rc::gen::inRange<std::uint32_t>(0, count);
    const auto edges =
        *rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(rc::gen::pair(node, node));
    std::vector<Vec2> start;
    for (std::uint32_t i = 0; i < count; ++i)
        start.emplace_back(*rc::gen::inRange(-3, 3) * 1000.0, *rc::gen::inRange(-3, 3) * 1000.0);
    const std::vector<Vec2> points = layOutGraph(start, edges);
    RC_ASSERT(points.size() == start.size());
    for (const Vec2& p : points)
        RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y) && glm::length(p) < 1000.0);
}

TEST(GraphLayout, noNodeGivesNoPosition) {
    EXPECT_TRUE(layOutGraph({}, {}).empty());
}

} // namespace
} // namespace limen::output
