#include "doctor/Machine.h"
#include "support/TemporaryDirectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limen::doctor {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

/// A computer without any fault.
MachineFacts goodMachine() {
    MachineFacts facts;
    gpu::Capabilities driver;
    driver.renderer = "A graphics card";
    driver.version = "4.6";
    driver.bindless = true;
    driver.maxAnisotropy = 16.0f;
    facts.driver = driver;
    facts.textureMemory = 4 * kGiB;
    facts.memory = 16 * kGiB;
    facts.availableMemory = 8 * kGiB;
    facts.display = {":0", "", true, ""};
    facts.font = "/fonts/font.ttf";
    facts.cache = {"/home/me/.cache/limen", "", 1000, 100 * kGiB};
    facts.configuration = {"/home/me/.config/limen", "", 0, 100 * kGiB};
    facts.ffmpeg = "/usr/bin/ffmpeg";
    return facts;
}

Finding findingOf(const MachineFacts& facts, const std::string& check) {
    for (const Finding& finding : judgeMachine(facts))
        if (finding.check == check)
            return finding;
    ADD_FAILURE() << "no check " << check;
    return {};
}

TEST(Machine, withoutFaultsIsOkThroughout) {
    for (const Finding& finding : judgeMachine(goodMachine())) {
        EXPECT_EQ(finding.outcome, Outcome::Ok) << finding.check;
        EXPECT_THAT(finding.next, IsEmpty()) << finding.check;
        EXPECT_LE(finding.check.size(), 16u);
    }
}

TEST(Machine, withoutDriverFailsAndLeavesItsFeaturesUntested) {
    MachineFacts facts = goodMachine();
    facts.driver = fail(ErrorCode::Driver, "EGL", "no context");
    EXPECT_EQ(findingOf(facts, "OpenGL driver").outcome, Outcome::Failed);
    EXPECT_THAT(findingOf(facts, "OpenGL driver").next, Not(IsEmpty()));
    for (const char* check : {"drawing speed", "bindless", "anisotropy", "texture memory"})
        EXPECT_EQ(findingOf(facts, check).outcome, Outcome::NotTested) << check;
}

TEST(Machine, driverWithoutFeaturesNamesTheLoss) {
    MachineFacts facts = goodMachine();
    facts.driver->software = true;
    facts.driver->bindless = false;
    facts.driver->maxAnisotropy = 1.0f;
    facts.textureMemory = kGiB / 8;
    EXPECT_EQ(findingOf(facts, "drawing speed").outcome, Outcome::Warning);
    EXPECT_EQ(findingOf(facts, "bindless").outcome, Outcome::Ok) << "nothing is lost but memory";
    EXPECT_THAT(findingOf(facts, "bindless").text, HasSubstr("memory"));
    EXPECT_EQ(findingOf(facts, "anisotropy").outcome, Outcome::Warning);
    EXPECT_EQ(findingOf(facts, "texture memory").outcome, Outcome::Warning);
    facts.textureMemory.reset();
    EXPECT_EQ(findingOf(facts, "texture memory").outcome, Outcome::NotTested);
}

TEST(Machine, memoryHasThreeGrades) {
    MachineFacts facts = goodMachine();
    facts.availableMemory = kGiB;
    EXPECT_EQ(findingOf(facts, "memory").outcome, Outcome::Warning);
    facts.availableMemory = kGiB / 4;
    EXPECT_EQ(findingOf(facts, "memory").outcome, Outcome::Failed);
    facts.availableMemory = 0;
    EXPECT_EQ(findingOf(facts, "memory").outcome, Outcome::NotTested);
}

TEST(Machine, missingDisplayIsAWarning) {
    MachineFacts facts = goodMachine();
    facts.display = {};
    EXPECT_EQ(findingOf(facts, "display").outcome, Outcome::Warning);
    facts.display = {":7", "", false};
    EXPECT_THAT(findingOf(facts, "display").text, HasSubstr(":7"));
    facts.display = {"", "wayland-0", false};
    EXPECT_THAT(findingOf(facts, "display").next, HasSubstr("Xwayland"));
}

TEST(Machine, directoriesThatCannotBeWrittenAreWarnings) {
    MachineFacts facts = goodMachine();
    facts.cache.problem = "Permission denied";
    EXPECT_EQ(findingOf(facts, "cache").outcome, Outcome::Warning);
    EXPECT_THAT(findingOf(facts, "cache").next, HasSubstr("XDG_CACHE_HOME"));
    EXPECT_EQ(findingOf(facts, "disk").outcome, Outcome::NotTested);
    facts.configuration.path.clear();
    EXPECT_THAT(findingOf(facts, "settings").text, HasSubstr("HOME"));
}

TEST(Machine, smallThingsAreWarnings) {
    MachineFacts facts = goodMachine();
    facts.font.clear();
    facts.ffmpeg.clear();
    facts.cache.freeBytes = kGiB / 4;
    for (const char* check : {"font", "films", "disk"})
        EXPECT_EQ(findingOf(facts, check).outcome, Outcome::Warning) << check;
    facts.cache.freeBytes = 1000;
    EXPECT_EQ(findingOf(facts, "disk").outcome, Outcome::Failed);
}

TEST(Machine, aDesktopWithoutX11IsOk) {
    MachineFacts facts = goodMachine();
    facts.display = {"", "", false, "the desktop of a system"};
    EXPECT_EQ(findingOf(facts, "display").outcome, Outcome::Ok);
    EXPECT_EQ(findingOf(facts, "display").text, "the desktop of a system");
}

TEST(QueryDirectory, reportsSizeAndWritability) {
    const test::TemporaryDirectory directory;
    test::putText(directory / "file", std::string(1000, 'x'));
    const DirectoryFacts facts = queryDirectory(directory.path());
    EXPECT_THAT(facts.problem, IsEmpty());
    EXPECT_EQ(facts.bytes, 1000u);
    EXPECT_GT(facts.freeBytes, 0u);
    EXPECT_EQ(directory.entryCount(), 1u) << "no file is left";
}

TEST(QueryDirectory, judgesTheNearestExistingDirectory) {
    const test::TemporaryDirectory directory;
    EXPECT_THAT(queryDirectory(directory / "not/there/yet").problem, IsEmpty());
    EXPECT_EQ(directory.entryCount(), 0u) << "nothing is made";
    test::putText(directory / "file", "");
    EXPECT_THAT(queryDirectory(directory / "file/below").problem, HasSubstr("not a directory"));
    EXPECT_THAT(queryDirectory("/proc/limen").problem, Not(IsEmpty()));
}

TEST(FindProgram, searchesThePath) {
    EXPECT_FALSE(findProgram("sh").empty());
    EXPECT_TRUE(findProgram("no-such-program-as-this").empty());
}

TEST(FindingTable, fitsIntoItsWidth) {
    const Findings findings{
        {"a check", Outcome::Ok, std::string(30, 'w') + " " + std::string(200, 'x'), ""},
        {"another", Outcome::NotTested, "short", "a step that takes more than one line to say"}};
    const std::string table = tableOf(findings, 60);
    std::istringstream lines(table);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        EXPECT_LE(line.size(), 60u) << line;
    EXPECT_GT(count, 6u);
    EXPECT_THAT(table, HasSubstr("another          not tested short"));
    EXPECT_THAT(table, HasSubstr("Next: a step"));
}

TEST(FindingTable, verdictCountsFailuresAndWarnings) {
    const Finding ok{"a", Outcome::Ok, "", ""}, warning{"b", Outcome::Warning, "", ""},
        failed{"c", Outcome::Failed, "", ""};
    EXPECT_EQ(verdictOf({ok}), "Ready: Limen can run, and the files are whole.");
    EXPECT_EQ(verdictOf({ok, warning}), "Ready: Limen can run, and the files are whole, 1 warning.");
    EXPECT_EQ(verdictOf({failed, warning, failed, warning}), "Not ready: 2 checks failed, 2 warnings.");
    EXPECT_TRUE(isSound({ok, warning}));
    EXPECT_FALSE(isSound({ok, failed}));
    const auto json = nlohmann::json::parse(findingsJson({ok, failed}));
    EXPECT_EQ(json["format"], "limen-doctor");
    EXPECT_EQ(json["ready"], false);
    EXPECT_EQ(json["checks"][1]["result"], "failed");
}

} // namespace
} // namespace limen::doctor
