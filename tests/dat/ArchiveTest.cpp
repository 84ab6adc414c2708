#include "dat/Archive.h"
#include "dat/Writer.h"

#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace limen::dat {
namespace {

using testing::HasSubstr;

/// Gives each test a temporary directory.
class ArchiveTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        directory_ = std::filesystem::temp_directory_path() /
                     ("limen-archive-" + std::to_string(::getpid()) + "-" + test->name());
        std::filesystem::create_directories(directory_);
        portal_.add(palette(0x04000001));
        cell_.add(block_);
    }
    void TearDown() override {
        std::error_code ignored;
        std::filesystem::remove_all(directory_, ignored);
    }
    static Palette palette(RecordId id) { return {id, {{0xFF112233}}}; }
    static RenderSurface image(RecordId id, std::int32_t width) {
        RenderSurface s;
        s.id = id;
        s.width = width;
        s.height = 1;
        s.format = PixelFormat::A8;
        s.pixels.assign(static_cast<std::size_t>(width), 0);
        return s;
    }
    void writeBoth() const {
        ASSERT_TRUE(portal_.write(directory_ / "client_portal.dat"));
        ASSERT_TRUE(cell_.write(directory_ / "client_cell_1.dat"));
    }
    Error openError() const {
        const auto archive = Archive::open(directory_);
        EXPECT_FALSE(archive);
        return archive ? Error{} : archive.error();
    }

    std::filesystem::path directory_;
    Writer portal_{FileTraits::portal()};
    Writer cell_{FileTraits::cell()};
    LandBlock block_{landBlockId({3, 4}), 0, {}, {}, 0};
};

TEST_F(ArchiveTest, loadsRecordsFromTheFileThatHoldsTheirType) {
    writeBoth();
    const auto archive = Archive::open(directory_);
    ASSERT_TRUE(archive) << archive.error().message();
    EXPECT_EQ(archive->highres(), nullptr);
    EXPECT_EQ(archive->local(), nullptr);
    EXPECT_EQ(archive->directory(), directory_);
    const auto p = archive->load<Palette>(0x04000001);
    ASSERT_TRUE(p) << p.error().message();
    EXPECT_EQ(p->colours[0].argb, 0xFF112233u);
    EXPECT_TRUE(archive->load<LandBlock>(landBlockId({3, 4})));
    EXPECT_TRUE(archive->contains<LandBlock>(landBlockId({3, 4})));
    EXPECT_FALSE(archive->contains<LandBlock>(landBlockId({4, 3})));
}

TEST_F(ArchiveTest, saysWhichFileHasNoSuchRecord) {
    writeBoth();
    const auto archive = Archive::open(directory_);
    ASSERT_TRUE(archive);
    const auto missing = archive->load<GfxObj>(0x01000009);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_THAT(missing.error().message(), HasSubstr("client_portal.dat: there is no record 0x01000009"));
    const auto wrongType = archive->load<GfxObj>(0x04000001);
    ASSERT_FALSE(wrongType);
    EXPECT_THAT(wrongType.error().what, HasSubstr("0x04000001 is not the id of a GfxObj"));
    EXPECT_FALSE(archive->contains<GfxObj>(0x04000001));
}

TEST_F(ArchiveTest, aDamagedRecordIsNamedWithFileIdAndOffset) {
    portal_.add(0x04000002, Bytes(7));
    writeBoth();
    const auto archive = Archive::open(directory_);
    ASSERT_TRUE(archive);
    const auto damaged = archive->load<Palette>(0x04000002);
    ASSERT_FALSE(damaged);
    EXPECT_THAT(damaged.error().message(), HasSubstr("client_portal.dat, record 0x04000002, offset 0x0: "));
}

TEST_F(ArchiveTest, imagesAreLookedForInPortalAndThenInHighres) {
    portal_.add(image(0x06000002, 2));
    portal_.add(image(0x06000003, 3));
    writeBoth();
    Writer highres(FileTraits::highres());
    highres.add(image(0x06000001, 8));
    highres.add(image(0x06000003, 9));
    const SurfaceTexture texture{0x05000001, 0, 2, {0x06000001, 0x06000002}};
    const auto without = Archive::open(directory_);
    ASSERT_TRUE(without);
    EXPECT_EQ(without->imageOf(texture).value(), 0x06000002u);
    EXPECT_FALSE(without->contains<RenderSurface>(0x06000001));
    ASSERT_TRUE(highres.write(directory_ / "client_highres.dat"));
    const auto with = Archive::open(directory_);
    ASSERT_TRUE(with) << with.error().message();
    EXPECT_EQ(with->imageOf(texture).value(), 0x06000001u);
    EXPECT_EQ(with->load<RenderSurface>(0x06000001)->width, 8);
    EXPECT_EQ(with->load<RenderSurface>(0x06000003)->width, 3) << "portal comes first";
    const auto none = with->imageOf({0x05000002, 0, 2, {0x06000077}});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
}

TEST_F(ArchiveTest, refusesAMissingDirectoryAndMissingFiles) {
    EXPECT_THAT(openError().message(), HasSubstr("client_portal.dat: there is no such file"));
    ASSERT_TRUE(portal_.write(directory_ / "client_portal.dat"));
    EXPECT_THAT(openError().message(), HasSubstr("client_cell_1.dat: there is no such file"));
    const auto nowhere = Archive::open(directory_ / "nowhere");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::NotFound);
    EXPECT_THAT(nowhere.error().message(), HasSubstr("there is no such directory"));
}

TEST_F(ArchiveTest, namesADirectoryOfOlderGameFilesForWhatItIs) {
    std::ofstream(directory_ / "portal.dat") << "any content";
    const Error error = openError();
    EXPECT_EQ(error.code, ErrorCode::Unsupported);
    EXPECT_THAT(error.what, HasSubstr("older than the end of retail"));
}

TEST_F(ArchiveTest, refusesAFileInAnothersPlace) {
    ASSERT_TRUE(portal_.write(directory_ / "client_portal.dat"));
    ASSERT_TRUE(portal_.write(directory_ / "client_cell_1.dat"));
    EXPECT_THAT(openError().what, HasSubstr("says that it is a portal file; a cell file was expected"));
    writeBoth();
    std::ofstream(directory_ / "client_highres.dat") << "not a dat";
    EXPECT_THAT(openError().message(), HasSubstr("client_highres.dat: this is a text file"));
}

TEST_F(ArchiveTest, refusesADirectoryInAFilesPlace) {
    ASSERT_TRUE(portal_.write(directory_ / "client_portal.dat"));
    std::filesystem::create_directory(directory_ / "client_cell_1.dat");
    EXPECT_EQ(openError().code, ErrorCode::Unreadable);
}

TEST_F(ArchiveTest, theWriterLeavesNothingBesideTheFileAndSaysWhatItCannotWrite) {
    writeBoth();
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory_))
        ++files;
    EXPECT_EQ(files, 2);
    const auto nowhere = portal_.write(directory_ / "missing" / "client_portal.dat");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::Unreadable);
    std::filesystem::create_directories(directory_ / "taken" / "inside");
    EXPECT_FALSE(portal_.write(directory_ / "taken"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / ("taken." + std::to_string(::getpid()) + ".part")));
}

TEST_F(ArchiveTest, manyThreadsReadOneArchive) {
    constexpr RecordId kCount = 5000;
    for (RecordId i = 0; i < kCount; ++i)
        portal_.add(Palette{0x04000000 + i, std::vector<Colour>(i % 600, Colour{i})});
    writeBoth();
    const auto archive = Archive::open(directory_);
    ASSERT_TRUE(archive);
    std::vector<std::thread> threads;
    std::vector<int> wrong(8);
    for (std::size_t t = 0; t < wrong.size(); ++t) {
        threads.emplace_back([&, t] {
            for (RecordId k = 0; k < kCount; ++k) {
                const RecordId i = (k * 7 + static_cast<RecordId>(t) * 613) % kCount;
                const auto p = archive->load<Palette>(0x04000000 + i);
                const bool good =
                    p && p->colours.size() == i % 600 && (p->colours.empty() || p->colours[0].argb == i);
                wrong[t] += good ? 0 : 1;
            }
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_THAT(wrong, testing::Each(0));
}

} // namespace
} // namespace limen::dat
