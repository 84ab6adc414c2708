#include "placements/sql/SqlFiles.h"
#include "SampleContent.h"
#include "SqlTestFiles.h"
#include "placements/Import.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

// Directories and archives of SQL files, and files that replace others.
namespace {

using namespace limen;
using namespace limen::test;
using placements::Content;

placements::Template named(std::uint32_t id, const std::string& name) {
    placements::Template of;
    of.id = id;
    of.className = "class" + std::to_string(id);
    of.name = name;
    return of;
}

std::string textOf(std::uint32_t id, const std::string& name) {
    return placements::sqlOf(named(id, name)).text;
}

void putIn(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    putText(path, text);
}

/// Writes an archive with these files.
void putArchive(const std::filesystem::path& path, int (*format)(archive*),
                const std::vector<std::pair<std::string, std::string>>& files) {
    archive* out = archive_write_new();
    format(out);
    ASSERT_EQ(archive_write_open_filename(out, path.c_str()), ARCHIVE_OK);
    for (const auto& [name, text] : files) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, name.c_str());
        archive_entry_set_size(entry, static_cast<la_int64_t>(text.size()));
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        archive_write_header(out, entry);
        archive_write_data(out, text.data(), text.size());
        archive_entry_free(entry);
    }
    archive_write_free(out);
}

std::string nameOf(const Result<Content>& content, std::uint32_t id) {
    if (!content)
        return content.error().message();
    const auto found = content->templates.find(id);
    return found != content->templates.end() ? found->second.name : "(none)";
}

TEST(SqlFiles, aPatchReplacesTheFileOfTheSameNameInTheSameNumberedFolder) {
    const TemporaryDirectory directory;
    putIn(directory / "core/Database/3-Core/9 WeenieDefaults/A/00001 Door.sql", textOf(1, "old"));
    putIn(directory / "core/9 WeenieDefaults/A/00002 Sign.sql", textOf(2, "kept"));
    putIn(directory / "core/5 Encounters/00001 Door.sql", textOf(3, "another folder"));
    putIn(directory / "patches/9 WeenieDefaults/B/00001 Door.sql", textOf(1, "new"));
    const Result<Content> content = placements::importSqlFiles({directory / "core", directory / "patches"});
    EXPECT_EQ(nameOf(content, 1), "new");
    EXPECT_EQ(nameOf(content, 2), "kept");
    EXPECT_EQ(nameOf(content, 3), "another folder");
    const auto files = placements::findSqlFiles({directory / "core", directory / "patches"});
    ASSERT_TRUE(files.has_value());
    EXPECT_EQ(files->size(), 3u) << "the replaced file is not read";
}

TEST(SqlFiles, aPatchWithAnotherNameReplacesByItsDelete) {
    const TemporaryDirectory directory;
    putIn(directory / "core/9 WeenieDefaults/00001 Door.sql", textOf(1, "old"));
    putIn(directory / "patches/9 WeenieDefaults/00001 Gate.sql", textOf(1, "new"));
    EXPECT_EQ(nameOf(placements::importSqlFiles({directory / "core", directory / "patches"}), 1), "new");
}

TEST(SqlFiles, anArchiveIsReadLikeADirectory) {
    const TemporaryDirectory directory;
    const Content content = SampleContent(3).make(4, 12);
    std::vector<std::pair<std::string, std::string>> files{{"readme.txt", "not SQL ' ("}};
    for (const auto& [id, landblock] : content.landblocks)
        files.emplace_back("world/" + placements::sqlOf(id, landblock).path,
                           placements::sqlOf(id, landblock).text);
    for (const auto& [id, of] : content.templates)
        files.emplace_back("world/" + placements::sqlOf(of).path, placements::sqlOf(of).text);
    putArchive(directory / "a.zip", archive_write_set_format_zip, files);
    putArchive(directory / "a.tar", archive_write_set_format_pax, files);
    for (const char* name : {"a.zip", "a.tar"}) {
        const Result<Content> read = placements::importSqlFiles({directory / name});
        ASSERT_TRUE(read.has_value()) << name << ": " << read.error().message();
        EXPECT_TRUE(*read == content) << name;
    }
}

TEST(SqlFiles, aPatchInADirectoryReplacesAFileOfAnArchive) {
    const TemporaryDirectory directory;
    putArchive(directory / "core.zip", archive_write_set_format_zip,
               {{"x/9 WeenieDefaults/00001 Door.sql", textOf(1, "old")},
                {"x/9 WeenieDefaults/00002 S.sql", textOf(2, "kept")}});
    putIn(directory / "p/9 WeenieDefaults/00001 Door.sql", textOf(1, "new"));
    const Result<Content> content = placements::importSqlFiles({directory / "core.zip", directory / "p"});
    EXPECT_EQ(nameOf(content, 1), "new");
    EXPECT_EQ(nameOf(content, 2), "kept");
}

TEST(SqlFiles, faultsNameThePath) {
    const TemporaryDirectory directory;
    const auto faultOf = [](const std::filesystem::path& path) {
        const Result<Content> content = placements::importSqlFiles({path});
        return content ? std::string("none") : content.error().message();
    };
    EXPECT_NE(faultOf(directory / "absent").find("absent: no such file or directory"), std::string::npos);
    std::filesystem::create_directory(directory / "empty");
    EXPECT_NE(faultOf(directory / "empty").find("empty: no file of SQL"), std::string::npos);
    putText(directory / "other.sql", "SELECT 1;");
    EXPECT_NE(faultOf(directory / "other.sql").find("no rows of landblock_instance or weenie"),
              std::string::npos);
    putText(directory / "noise.zip", "this is no archive");
    EXPECT_NE(faultOf(directory / "noise.zip").find("noise.zip: cannot be read as an archive"),
              std::string::npos);
    putText(directory / "cut.sql", textOf(1, "a").substr(0, 90));
    EXPECT_NE(faultOf(directory / "cut.sql").find("cut.sql:3: the file ends within a statement"),
              std::string::npos)
        << faultOf(directory / "cut.sql");
    EXPECT_EQ(faultOf(directory / "cut.sql").find("cut.sql/"), std::string::npos) << "the name stands once";
}

TEST(SqlFiles, aDamagedArchiveIsAnError) {
    const TemporaryDirectory directory;
    std::vector<std::pair<std::string, std::string>> files;
    for (std::uint32_t i = 1; i < 50; ++i)
        files.emplace_back(std::to_string(i) + ".sql", textOf(i, "name"));
    putArchive(directory / "a.zip", archive_write_set_format_zip, files);
    const std::string bytes = getText(directory / "a.zip");
    putText(directory / "cut.zip", bytes.substr(0, bytes.size() / 2));
    EXPECT_FALSE(placements::importSqlFiles({directory / "cut.zip"}).has_value());
}

TEST(SqlFiles, anArchiveThatUnpacksWithoutEndIsAnError) {
    const TemporaryDirectory directory;
    const std::string comment = "/*" + std::string(std::size_t{80} << 20, 'x') + "*/";
    archive* out = archive_write_new();
    archive_write_set_format_zip(out);
    ASSERT_EQ(archive_write_open_filename(out, (directory / "bomb.zip").c_str()), ARCHIVE_OK);
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, "a.sql");
    archive_entry_set_size(entry, static_cast<la_int64_t>(comment.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_write_header(out, entry);
    archive_write_data(out, comment.data(), comment.size());
    archive_entry_free(entry);
    archive_write_free(out);
    const auto content = placements::importSqlFiles({directory / "bomb.zip"});
    ASSERT_FALSE(content.has_value());
    EXPECT_NE(content.error().message().find("more than 100 times"), std::string::npos)
        << content.error().message();
}

TEST(SqlFiles, progressCancels) {
    const TemporaryDirectory directory;
    putContent(directory.path(), SampleContent(1).make(3, 3));
    std::size_t calls = 0, last = 0, total = 0;
    ASSERT_TRUE(placements::importSqlFiles({directory.path()}, [&](std::size_t done, std::size_t of) {
                    EXPECT_GE(done, last);
                    last = done;
                    total = of;
                    ++calls;
                    return true;
                }).has_value());
    EXPECT_GT(calls, 5u);
    EXPECT_EQ(last, total) << "the last call reports all bytes";
    const auto cancelled =
        placements::importSqlFiles({directory.path()}, [](std::size_t, std::size_t) { return false; });
    ASSERT_FALSE(cancelled.has_value());
    EXPECT_NE(cancelled.error().message().find("cancelled"), std::string::npos);
}

} // namespace
