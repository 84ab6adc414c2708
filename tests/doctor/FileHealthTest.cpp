#include "doctor/FileHealth.h"

#include "dat/Writer.h"
#include "doctor/OriginalRecords.h"
#include "doctor/Releases.h"
#include "doctor/WorldHealth.h"
#include "support/TemporaryDirectory.h"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::doctor {
namespace {

using testing::HasSubstr;

constexpr std::size_t kFileSizeAt = 0x148, kFirstFreeAt = 0x154, kFreeCountAt = 0x15C;

void putWordAt(dat::Bytes& bytes, std::size_t at, std::uint32_t word) {
    std::memcpy(bytes.data() + at, &word, sizeof word);
}

/// A directory with a small, sound world.
class FileHealthTest : public testing::Test {
protected:
    FileHealthTest() : portal(*test::OriginalRecords(test::Values::AsStated).portal().build()) {
        dat::Writer cells(dat::FileTraits::cell());
        dat::LandBlock land;
        for (std::uint32_t x = 0; x < 200; ++x) {
            land.id = x << 24 | 0xFFFF;
            cells.add(land);
        }
        cell = *cells.build();
    }
    [[nodiscard]] std::filesystem::path put(const char* name, const dat::Bytes& bytes) const {
        test::putText(directory / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return directory / name;
    }
    [[nodiscard]] Finding judged(const dat::Bytes& bytes, const std::string& check) const {
        const FileHealth health = examineFile(put("client_portal.dat", bytes), dat::FileRole::Portal, true);
        for (const Finding& finding : judgeFile(health))
            if (finding.check == check)
                return finding;
        return {"", Outcome::NotTested, "no such check", ""};
    }
    dat::Bytes portal, cell;
    test::TemporaryDirectory directory;
};

TEST_F(FileHealthTest, soundFileIsOk) {
    const FileHealth health = examineFile(put("client_portal.dat", portal), dat::FileRole::Portal, true);
    EXPECT_TRUE(health.isSound());
    EXPECT_GT(health.records, 50u);
    EXPECT_EQ(health.byKind[static_cast<std::size_t>(dat::RecordKind::Region)], 1u);
    EXPECT_GE(health.shape.nodes, 1u);
    const Findings findings = judgeFile(health);
    EXPECT_EQ(findings.size(), 4u);
    for (const Finding& finding : findings)
        EXPECT_EQ(finding.outcome, Outcome::Ok) << finding.check << ": " << finding.text;
}

TEST_F(FileHealthTest, missingFileFailsOnlyIfItIsRequired) {
    const Finding required =
        judgeFile(examineFile(directory / "client_portal.dat", dat::FileRole::Portal, true)).front();
    EXPECT_EQ(required.outcome, Outcome::Failed);
    EXPECT_THAT(required.text, HasSubstr("client_portal.dat"));
    EXPECT_EQ(judgeFile(examineFile(directory / "x.dat", dat::FileRole::Highres, false)).front().outcome,
              Outcome::Ok);
}

TEST_F(FileHealthTest, textIsNoDatFile) {
    const char text[] = "This is a text.";
    dat::Bytes bytes(std::size(text) - 1);
    std::memcpy(bytes.data(), text, bytes.size());
    const Finding finding = judged(bytes, "portal");
    EXPECT_EQ(finding.outcome, Outcome::Failed);
    EXPECT_THAT(finding.text, HasSubstr("text file"));
}

TEST_F(FileHealthTest, shortenedFileFailsWithItsName) {
    dat::Bytes half(portal.begin(), portal.begin() + static_cast<std::ptrdiff_t>(portal.size() / 2));
    const Finding finding = judged(half, "portal");
    EXPECT_EQ(finding.outcome, Outcome::Failed);
    EXPECT_THAT(finding.text, HasSubstr("client_portal.dat"));
}

TEST_F(FileHealthTest, fileOfAnotherRoleFails) {
    EXPECT_THAT(judged(cell, "portal").text, HasSubstr("a cell file"));
}

TEST_F(FileHealthTest, otherLengthThanTheHeaderIsNamed) {
    portal.resize(portal.size() + 1024);
    EXPECT_EQ(judged(portal, "portal").outcome, Outcome::Warning) << "longer: every record can be read";
    putWordAt(portal, kFileSizeAt, static_cast<std::uint32_t>(portal.size() + 1024));
    EXPECT_EQ(judged(portal, "portal").outcome, Outcome::Failed);
}

TEST_F(FileHealthTest, freeListIsFollowed) {
    const auto block = static_cast<std::uint32_t>(portal.size());
    portal.resize(portal.size() + 2048);
    putWordAt(portal, kFileSizeAt, static_cast<std::uint32_t>(portal.size()));
    putWordAt(portal, kFirstFreeAt, block);
    putWordAt(portal, kFirstFreeAt + 4, block + 1024);
    putWordAt(portal, kFreeCountAt, 2);
    putWordAt(portal, block, (block + 1024) | 0x80000000);
    putWordAt(portal, block + 1024, 0x80000000);
    EXPECT_EQ(judged(portal, "portal free").outcome, Outcome::Ok);
    EXPECT_THAT(judged(portal, "portal free").text, HasSubstr("2 free blocks"));
    dat::Bytes other = portal;
    putWordAt(other, kFreeCountAt, 3);
    EXPECT_EQ(judged(other, "portal free").outcome, Outcome::Warning) << "fewer than counted";
    other = portal;
    putWordAt(other, kFreeCountAt, 1);
    EXPECT_EQ(judged(other, "portal free").outcome, Outcome::Warning) << "more than counted";
    other = portal;
    putWordAt(other, block, block + 1024);
    EXPECT_THAT(judged(other, "portal free").text, HasSubstr("not marked as free"));
    other = portal;
    putWordAt(other, kFreeCountAt, 0xFFFFFFFF);
    EXPECT_EQ(judged(other, "portal free").outcome, Outcome::Warning);
    other = portal;
    putWordAt(other, kFirstFreeAt, 12345);
    EXPECT_THAT(judged(other, "portal free").text, HasSubstr("not the offset of a block"));
}

TEST_F(FileHealthTest, damagedIndexNodeIsNamedByOffset) {
    dat::Bytes bytes = cell;
    std::uint32_t root = 0;
    std::memcpy(&root, bytes.data() + 0x160, sizeof root);
    putWordAt(bytes, root + 4, 3); // a branch that is no offset
    const FileHealth health = examineFile(put("client_cell_1.dat", bytes), dat::FileRole::Cell, true);
    ASSERT_TRUE(health.error);
    EXPECT_FALSE(health.isSound());
    EXPECT_THAT(judgeFile(health).front().text, HasSubstr("0x"));
}

class WorldHealthTest : public FileHealthTest {
protected:
    [[nodiscard]] Findings world(bool thorough = false) const {
        std::vector<FileHealth> files;
        files.push_back(examineFile(put("client_portal.dat", portal), dat::FileRole::Portal, true));
        files.push_back(examineFile(put("client_cell_1.dat", cell), dat::FileRole::Cell, true));
        return judgeWorld(files, {thorough, {}});
    }
    [[nodiscard]] static Outcome outcomeOf(const Findings& findings, const std::string& check) {
        for (const Finding& finding : findings)
            if (finding.check == check)
                return finding.outcome;
        ADD_FAILURE() << "no check " << check;
        return Outcome::NotTested;
    }
};

TEST_F(WorldHealthTest, namesMissingRecords) {
    portal = *dat::Writer(dat::FileTraits::portal()).build();
    const Findings findings = world();
    EXPECT_EQ(outcomeOf(findings, "region"), Outcome::Failed);
    EXPECT_EQ(outcomeOf(findings, "land and cells"), Outcome::Ok);
    EXPECT_EQ(outcomeOf(findings, "shapes"), Outcome::Warning) << "no surfaces";
    cell = *dat::Writer(dat::FileTraits::cell()).build();
    EXPECT_EQ(outcomeOf(world(), "land and cells"), Outcome::Failed);
    EXPECT_EQ(outcomeOf(world(), "region"), Outcome::Warning) << "without landscape";
}

TEST_F(WorldHealthTest, sampleAndThoroughFindADamagedRecord) {
    dat::Writer cells(dat::FileTraits::cell());
    dat::LandBlock land;
    for (std::uint32_t x = 0; x < 200; ++x) {
        land.id = x << 24 | 0xFFFF;
        cells.add(land);
    }
    cells.add(0x0000FFFF, dat::Bytes(7)); // the first of its kind is in every sample
    cell = *cells.build();
    EXPECT_EQ(outcomeOf(world(), "sample"), Outcome::Failed);
    const Findings thorough = world(true);
    EXPECT_EQ(outcomeOf(thorough, "all records"), Outcome::Failed);
    EXPECT_TRUE(std::any_of(thorough.begin(), thorough.end(), [](const Finding& finding) {
        return finding.text.find("0x0000FFFF") != std::string::npos;
    }));
}

TEST_F(WorldHealthTest, sampleOfASoundWorldIsOk) {
    EXPECT_EQ(outcomeOf(world(), "sample"), Outcome::Ok);
    EXPECT_EQ(outcomeOf(world(), "region"), Outcome::Ok);
}

TEST(Releases, areRecognisedByTheirFigures) {
    FileIdentity file{
        dat::FileRole::Cell,
        22,
        6657,
        {0xD2, 0xD7, 0xA7, 0x34, 0x2F, 0x72, 0x46, 0x4C, 0x8A, 0xB4, 0xEF, 0x51, 0x4F, 0x85, 0x6F, 0xFD},
        348127232,
        805003};
    EXPECT_EQ(releaseOf(file), Release::EndOfRetail);
    file.records = 0; // not counted
    EXPECT_EQ(releaseOf(file), Release::EndOfRetail);
    file.records = 800000;
    EXPECT_EQ(releaseOf(file), Release::EndOfRetailChanged);
    FileIdentity other = file;
    other.majorVersion[3] = 0;
    EXPECT_EQ(releaseOf(other), Release::Unknown);
    other = file;
    other.minorVersion = 6000;
    EXPECT_EQ(releaseOf(other), Release::Unknown);
    file.records = 805348;
    FileIdentity portal = file;
    portal.role = dat::FileRole::Portal;
    portal.engineVersion = 110;
    portal.length = 926941184;
    portal.records = 79694;
    EXPECT_EQ(releaseOf(portal, file), Release::EndOfRetail);
    EXPECT_EQ(releaseOf(portal, other), Release::Unknown);
}

} // namespace
} // namespace limen::doctor
