#include "dat/Verify.h"

#include "dat/RandomRecords.h"
#include "dat/RecordTypes.h"
#include "dat/Writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::dat {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr RecordId kBlock = 0x12340000;

/// A portal and a cell file in memory, with consistent records of several kinds.
struct Files {
    Writer portal{FileTraits::portal()}, cell{FileTraits::cell()}, highres{FileTraits::highres()};
    bool withPortal = true, withHighres = false;

    Files() {
        portal.add(Palette{0x04000001, {{0xFF112233}}});
        RenderSurface picture;
        picture.id = 0x06000001;
        picture.format = PixelFormat::P8;
        picture.width = picture.height = 1;
        picture.pixels = {0};
        picture.defaultPalette = 0x04000001;
        portal.add(picture);
        portal.add(SurfaceTexture{0x05000001, 0, 2, {0x06000001}});
        Surface surface;
        surface.type = Surface::kBase1Image;
        surface.texture = 0x05000001;
        portal.add(0x08000001, surface);
        Environment environment;
        environment.id = 0x0D000001;
        CellStruct shape;
        shape.portalPolygons = {7};
        BspNode leaf;
        leaf.tag = BspTag::Leaf;
        shape.cellBsp.nodes = {leaf};
        shape.physicsBsp.nodes = {leaf};
        environment.cells = {{0, shape}};
        portal.add(environment);
        cell.add(cellWithPortal(0x0100, 0x0101, 0));
        cell.add(cellWithPortal(0x0101, 0x0100, 0));
        LandBlockInfo info;
        info.id = kBlock | 0xFFFE;
        info.numCells = 2;
        cell.add(info);
        LandBlock land;
        land.id = kBlock | 0xFFFF;
        land.hasObjects = 1;
        cell.add(land);
    }

    static EnvCell cellWithPortal(std::uint16_t low, std::uint16_t to, std::uint16_t portal) {
        EnvCell out;
        out.id = kBlock | low;
        out.surfaces = {1};
        out.environment = 1;
        out.portals = {{0, 7, to, portal}};
        return out;
    }

    VerifyReport verified(const VerifyOptions& options = {}) const {
        std::vector<File> files;
        if (withPortal)
            files.push_back(*File::fromBytes(*portal.build(), "portal"));
        files.push_back(*File::fromBytes(*cell.build(), "cell"));
        if (withHighres)
            files.push_back(*File::fromBytes(*highres.build(), "highres"));
        std::vector<const File*> list;
        for (const File& file : files)
            list.push_back(&file);
        return verify(list, options);
    }
};

std::vector<std::string> whatsOf(const VerifyReport& report) {
    std::vector<std::string> whats;
    for (const Fault& fault : report.faults)
        whats.push_back(fault.what);
    return whats;
}

TEST(Verify, findsNothingInFilesThatAreWhole) {
    const VerifyReport report = Files().verified();
    EXPECT_THAT(whatsOf(report), ElementsAre());
    EXPECT_TRUE(report.isClean());
    EXPECT_EQ(report.byKind[static_cast<std::size_t>(RecordKind::EnvCell)].records, 2u);
    EXPECT_GT(report.byKind[static_cast<std::size_t>(RecordKind::EnvCell)].bytes, 80u);
    EXPECT_EQ(report.byKind[static_cast<std::size_t>(RecordKind::Iteration)].records, 2u);
}

TEST(Verify, tellsWhichRecordNamesWhatIsNotThere) {
    Files files;
    PaletteSet set;
    set.id = 0x0F000001;
    set.palettes = {0x04000001, 0x04000002};
    files.portal.add(set);
    const VerifyReport report = files.verified();
    ASSERT_EQ(report.faults.size(), 1u);
    EXPECT_EQ(report.faults[0].kind, FaultKind::Unresolved);
    EXPECT_EQ(report.faults[0].id, 0x0F000001u);
    EXPECT_EQ(report.faults[0].role, FileRole::Portal);
    EXPECT_EQ(report.faults[0].what, "names Palette 0x04000002 as a palette, and there is none");
}

TEST(Verify, doesNotBlameAFileForWhatAnotherWouldHold) {
    Files files;
    files.withPortal = false;
    EXPECT_TRUE(files.verified().isClean());
}

TEST(Verify, takesOneImageOfManyAlsoFromHighres) {
    Files files;
    files.portal.add(SurfaceTexture{0x05000002, 0, 2, {0x06000009, 0x06000001}});
    EXPECT_TRUE(files.verified().isClean());
    files.portal.add(SurfaceTexture{0x05000003, 0, 2, {0x06000009}});
    EXPECT_THAT(whatsOf(files.verified()), ElementsAre("none of its 1 images is there"));
    RenderSurface picture;
    picture.id = 0x06000009;
    files.highres.add(picture);
    files.withHighres = true;
    EXPECT_TRUE(files.verified().isClean());
}

TEST(Verify, followsCellsToTheirShapesAndPortals) {
    Files files;
    EnvCell noShape = Files::cellWithPortal(0x0100, 0x0101, 0);
    noShape.cellStructure = 3;
    files.cell.add(noShape);
    EXPECT_THAT(whatsOf(files.verified()),
                ElementsAre("has shape 3 of Environment 0x0D000001, which has no such shape"));
    EnvCell noPolygon = Files::cellWithPortal(0x0100, 0x0101, 0);
    noPolygon.portals[0].polygonId = 8;
    files.cell.add(noPolygon);
    EXPECT_THAT(whatsOf(files.verified()),
                ElementsAre("has a portal on polygon 8, which is none of its shape's portals"));
    files.cell.add(Files::cellWithPortal(0x0100, 0x0101, 1));
    EXPECT_THAT(whatsOf(files.verified()),
                ElementsAre("a portal leads to portal 1 of cell 0x12340101, which has 1"));
    files.cell.add(Files::cellWithPortal(0x0100, 0x0102, 0));
    EXPECT_THAT(whatsOf(files.verified()),
                ElementsAre("names EnvCell 0x12340102 as the cell behind a portal, and there is none"));
    files.cell.add(Files::cellWithPortal(0x0100, kOutdoors, kNoPortal));
    EXPECT_TRUE(files.verified().isClean());
}

TEST(Verify, followsBuildingsToTheirCells) {
    Files files;
    LandBlockInfo info;
    info.id = kBlock | 0xFFFE;
    info.numCells = 3;
    Building building;
    building.portals = {{0, 0x0100, 4, {0x0105}, {}}};
    info.buildings = {building};
    files.cell.add(info);
    EXPECT_THAT(whatsOf(files.verified()),
                ElementsAre(HasSubstr("EnvCell 0x12340102 as one of its cells"),
                            HasSubstr("EnvCell 0x12340105 as a cell seen through a building's portal"),
                            "a building's portal leads to portal 4 of cell 0x12340100, which has 1"));
}

TEST(Verify, tellsUnreadableRecordsAndCountsWhatItDoesNotKeep) {
    Files files;
    files.portal.add(0x01000001, Bytes(3));
    files.portal.add(0x02000001, Bytes(3));
    files.portal.add(0x0A000001, Bytes(3)); // a sound: counted, not decoded
    std::size_t told = 0, ofAll = 0;
    const VerifyReport report =
        files.verified({.mostFaults = 1, .progress = [&](std::size_t total, std::size_t done) {
                            told = done;
                            ofAll = total;
                        }});
    EXPECT_EQ(report.faultCounts[static_cast<std::size_t>(FaultKind::Unreadable)], 2u);
    ASSERT_EQ(report.faults.size(), 1u);
    EXPECT_THAT(report.faults[0].what, HasSubstr("offset 0x0"));
    EXPECT_EQ(report.byKind[static_cast<std::size_t>(RecordKind::Other)].records, 1u);
    EXPECT_EQ(told, ofAll);
    EXPECT_EQ(ofAll, 14u) << "nine of the portal's, five of the cell's";
}

// All references are reported: a random record alone in a file resolves only references to itself.
template <class Record>
class References : public testing::Test {};
TYPED_TEST_SUITE(References, RecordTypes::As<testing::Types>);

TYPED_TEST(References, ofRandomRecordsAreJudgedWithoutHarm) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        constexpr RecordKind kind = kKindOf<TypeParam>;
        const bool isCell = kind >= RecordKind::LandBlock && kind <= RecordKind::EnvCell;
        auto record = RandomRecords(seed).make<TypeParam>();
        RecordId id = 0x08000001;
        for (RecordId high = 1; high < 0x40 && !isCell; ++high)
            if (kindOf(FileRole::Portal, high << 24) == kind)
                id = high << 24;
        if (isCell)
            id = kBlock | (kind == RecordKind::LandBlock       ? 0xFFFFu
                           : kind == RecordKind::LandBlockInfo ? 0xFFFEu
                                                               : 0x0100u);
        if constexpr (requires { record.id; })
            record.id = id;
        Writer writer(isCell ? FileTraits::cell() : FileTraits::portal());
        writer.add(id, *encode(record));
        const File file = *File::fromBytes(*writer.build(), "one");
        const File* const list[] = {&file};
        const VerifyReport report = verify(list);
        EXPECT_EQ(report.byKind[static_cast<std::size_t>(kind)].records, 1u);
        EXPECT_EQ(report.faultCounts[static_cast<std::size_t>(FaultKind::Unreadable)], 0u);
        EXPECT_EQ(report.faultCounts[static_cast<std::size_t>(FaultKind::Changed)], 0u);
    }
}

} // namespace
} // namespace limen::dat
