#include "doctor/retail/Ledger.h"

#include "doctor/retail/Suite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limen::doctor {
namespace {

Verdict judgedAlone(Fact fact, std::optional<Numbers> found) {
    Ledger ledger;
    ledger.judge(std::move(fact), std::move(found));
    return ledger.lines().front().verdict;
}

Fact factOf(Numbers expected) {
    return {"area.subject", "test", std::move(expected)};
}

TEST(Ledger, comparesByTheRule) {
    EXPECT_EQ(judgedAlone(factOf({1, 2}), Numbers{1, 2}), Verdict::Right);
    EXPECT_EQ(judgedAlone(factOf({1, 2}), Numbers{1, 2.001}), Verdict::Wrong);
    EXPECT_EQ(judgedAlone(factOf({1, 2}).within(0.01), Numbers{1, 2.001}), Verdict::Right);
    EXPECT_EQ(judgedAlone(factOf({1, 2}), Numbers{1}), Verdict::Wrong);
    EXPECT_EQ(judgedAlone(factOf({7}).by(Rule::AtLeast), Numbers{7}), Verdict::Right);
    EXPECT_EQ(judgedAlone(factOf({7}).by(Rule::AtLeast), Numbers{6.9}), Verdict::Wrong);
    EXPECT_EQ(judgedAlone(factOf({7}).by(Rule::AtMost), Numbers{7}), Verdict::Right);
    EXPECT_EQ(judgedAlone(factOf({7}).by(Rule::AtMost), Numbers{7.1}), Verdict::Wrong);
    EXPECT_EQ(judgedAlone(factOf({7, 9}).by(Rule::OneOf), Numbers{9}), Verdict::Right);
    EXPECT_EQ(judgedAlone(factOf({7, 9}).by(Rule::OneOf), Numbers{8}), Verdict::Wrong);
    EXPECT_EQ(judgedAlone(factOf({7}), std::nullopt), Verdict::NotThere);
}

TEST(Ledger, separatesMissingFromDamagedRecords) {
    const auto read = [](int value) { return std::optional(Numbers{static_cast<double>(value)}); };
    const auto lacks = [](int) { return std::optional<Numbers>(); };
    Ledger ledger;
    ledger.judgeRecord(Result<int>(1), factOf({1}), read);
    ledger.judgeRecord(Result<int>(1), factOf({1}), lacks);
    ledger.judgeRecord(Result<int>(fail(ErrorCode::NotFound, "", "")), factOf({1}), read);
    ledger.judgeRecord(Result<int>(fail(ErrorCode::Malformed, "", "")), factOf({1}), read);
    std::vector<Verdict> verdicts;
    for (const Line& line : ledger.lines())
        verdicts.push_back(line.verdict);
    EXPECT_THAT(verdicts,
                testing::ElementsAre(Verdict::Right, Verdict::Wrong, Verdict::NotThere, Verdict::Wrong));
}

TEST(RetailReport, holdsNumbersOfFactsAlone) {
    SuiteResult result;
    result.ledger.judge(factOf({1}), Numbers{1});
    result.ledger.judge(factOf({0x01000830}).hex(), Numbers{0x01000907});
    result.ledger.judge(factOf({2}), std::nullopt);
    const auto report = nlohmann::json::parse(reportJson(result, "limen 1.2.3"));
    EXPECT_EQ(report["format"], "limen-retail-report");
    EXPECT_EQ(report["version"], kReportVersion);
    EXPECT_EQ(report["program"], "limen 1.2.3");
    EXPECT_EQ(report["release"], "unknown release");
    EXPECT_EQ(report["right"], 1);
    EXPECT_EQ(report["wrong"], 1);
    EXPECT_EQ(report["notThere"], 1);
    ASSERT_EQ(report["lines"].size(), 3u);
    EXPECT_FALSE(report["lines"][0].contains("found")) << "a right value is not repeated";
    EXPECT_EQ(report["lines"][1]["expected"], nlohmann::json({"01000830"}));
    EXPECT_EQ(report["lines"][1]["found"], nlohmann::json({"01000907"}));
    EXPECT_EQ(report["lines"][2]["verdict"], "not there");
    for (const auto& line : report["lines"])
        for (const auto& [key, value] : line.items())
            EXPECT_THAT(key, testing::AnyOf("id", "expected", "verdict", "found", "rule", "tolerance"));
}

TEST(RetailReport, textListsTheWrongLinesFirst) {
    SuiteResult result;
    result.ledger.judge({"a.missing", "test", {1}}, std::nullopt);
    result.ledger.judge({"a.wrong", "test", {1}}, Numbers{5});
    result.ledger.judge({"b.right", "test", {1}}, Numbers{1});
    const std::string text = reportText(result, 1, false);
    EXPECT_THAT(text, testing::HasSubstr("expected 1, found 5 (test)"));
    EXPECT_THAT(text, testing::HasSubstr("... and 1 more"));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("b.right")));
    EXPECT_THAT(reportText(result, 1, true), testing::HasSubstr("b.right"));
    EXPECT_THAT(text, testing::HasSubstr("3 facts: 1 right, 1 wrong, 1 not there"));
}

} // namespace
} // namespace limen::doctor
