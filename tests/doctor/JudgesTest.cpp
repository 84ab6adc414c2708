#include "doctor/retail/Judges.h"
#include "doctor/OriginalRecords.h"
#include "doctor/retail/Counts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::doctor {
namespace {

using test::OriginalRecords;
using test::Values;
using Judge = void (*)(const dat::Archive&, Ledger&);

/// All judges of records.
class JudgesOfRecords : public testing::TestWithParam<Judge> {
protected:
    [[nodiscard]] Ledger judged(const dat::Archive& archive) const {
        Ledger ledger;
        GetParam()(archive, ledger);
        return ledger;
    }
};

/// Facts about positions alone, which no record can change.
bool needsNoFiles(const Line& line) {
    return line.fact.id.ends_with(".landcell");
}

std::string inWords(const Line& line) {
    return line.fact.id + ": expected " + expectationOf(line.fact) + ", found " +
           textOf(line.found, line.fact.notation);
}

TEST_P(JudgesOfRecords, findRecordsWithTheStatedValuesRight) {
    static const dat::Archive archive = OriginalRecords(Values::AsStated).archive();
    const Ledger ledger = judged(archive);
    EXPECT_FALSE(ledger.lines().empty());
    for (const Line& line : ledger.lines())
        EXPECT_EQ(line.verdict, Verdict::Right) << inWords(line);
}

TEST_P(JudgesOfRecords, findEveryChangedValueWrong) {
    static const dat::Archive archive = OriginalRecords(Values::Changed).archive();
    const Ledger ledger = judged(archive);
    for (const Line& line : ledger.lines())
        EXPECT_TRUE(line.verdict == Verdict::Wrong || needsNoFiles(line)) << inWords(line);
}

TEST_P(JudgesOfRecords, findMissingRecordsNotThere) {
    const Ledger ledger = judged(test::emptyArchive());
    for (const Line& line : ledger.lines())
        EXPECT_TRUE(line.verdict == Verdict::NotThere || needsNoFiles(line)) << inWords(line);
}

INSTANTIATE_TEST_SUITE_P(Areas, JudgesOfRecords,
                         testing::Values(judgeSurfaces, judgeModels, judgeLand, judgeCalendar, judgeSky,
                                         judgeCells, judgePlaces, judgeEffects));

TEST(JudgesOfDamage, findADamagedRecordWrong) {
    dat::Writer portal(dat::FileTraits::portal());
    portal.add(0x0800006B, dat::Bytes(3));
    Ledger ledger;
    judgeSurfaces(test::archiveOf(portal, dat::Writer(dat::FileTraits::cell())), ledger);
    EXPECT_EQ(ledger.lines().front().verdict, Verdict::Wrong);
    EXPECT_TRUE(ledger.lines().front().found.empty());
}

TEST(Counts, areJudgedOneByOne) {
    Census census;
    for (const CountFact& fact : countFacts())
        census[fact.basis] = 1;
    for (const CountFact& fact : countFacts())
        census[fact.tally] = fact.expected;
    Ledger right;
    judgeCounts(census, right);
    for (const Line& line : right.lines())
        EXPECT_EQ(line.verdict, Verdict::Right) << line.fact.id;

    for (std::size_t i = 0; i < countFacts().size(); ++i) {
        const CountFact& fact = countFacts()[i];
        Census other = census;
        other[fact.tally] += 1 + fact.tolerance;
        Ledger ledger;
        judgeCounts(other, ledger);
        EXPECT_EQ(ledger.lines()[i].verdict, Verdict::Wrong) << fact.id;
    }

    Ledger none;
    judgeCounts({}, none);
    EXPECT_EQ(none.count(Verdict::NotThere), countFacts().size());
}

TEST(Container, headerOfAnotherFileIsWrong) {
    const dat::Archive archive = test::emptyArchive();
    const Result<Census> census = takeCensus(archive);
    ASSERT_TRUE(census);
    Ledger ledger;
    judgeContainer(archive, *census, ledger);
    const auto verdictOf = [&](std::string_view id) {
        for (const Line& line : ledger.lines())
            if (line.fact.id == id)
                return line.verdict;
        ADD_FAILURE() << "no fact " << id;
        return Verdict::Wrong;
    };
    EXPECT_EQ(verdictOf("container.portal.blockSize"), Verdict::Right);
    EXPECT_EQ(verdictOf("container.cell.blockSize"), Verdict::Right);
    EXPECT_EQ(verdictOf("container.portal.minorVersion"), Verdict::Right);
    EXPECT_EQ(verdictOf("container.portal.fileSize"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.portal.majorVersion"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.portal.records"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.portal.freeBlocks"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.portal.iteration"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.cell.rootKeys"), Verdict::Wrong);
    EXPECT_EQ(verdictOf("container.highres.blockSize"), Verdict::NotThere);
    EXPECT_EQ(verdictOf("container.local.rootKeys"), Verdict::NotThere);
}

TEST(Rules, areRight) {
    Ledger ledger;
    judgeRules(ledger);
    EXPECT_GT(ledger.lines().size(), 40u);
    for (const Line& line : ledger.lines())
        EXPECT_EQ(line.verdict, Verdict::Right) << inWords(line);
}

} // namespace
} // namespace limen::doctor
