#include "engine/DatDirectory.h"

#include "engine/WorldSource.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Generated.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;
using test::putText;

class DatDirectoryTest : public testing::Test {
protected:
    DatDirectoryTest() : game_(root_ / "Games/Turbine/Asheron's Call") {
        fs::create_directories(game_);
        for (const char* name : {"client_portal.dat", "client_cell_1.dat", "client_highres.dat"})
            putText(game_ / name, "x");
    }
    /// The text of the error for a path; empty if something was found.
    static std::string errorFor(const fs::path& path) {
        const Result<DatDirectory> found = findDatDirectory(path);
        return found ? "" : found.error().message();
    }

    test::TemporaryDirectory root_;
    fs::path game_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(DatDirectoryTest, isTheDirectoryItself) {
    const Result<DatDirectory> found = findDatDirectory(game_);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_EQ(found->directory, game_);
    EXPECT_EQ(found->paths.portal, game_ / "client_portal.dat");
    EXPECT_EQ(found->paths.highres, game_ / "client_highres.dat");
    EXPECT_TRUE(found->paths.local.empty());
    EXPECT_EQ(found->absent, std::vector<std::string>{"client_local_English.dat"});
}

TEST_F(DatDirectoryTest, isFoundFromADirectoryAboveAndFromAFile) {
    for (const fs::path& given : {game_.parent_path(), game_.parent_path().parent_path(),
                                  game_ / "client_cell_1.dat", game_ / "client_local_English.dat"}) {
        const Result<DatDirectory> found = findDatDirectory(given);
        ASSERT_TRUE(found) << found.error().message();
        EXPECT_EQ(found->directory, game_) << given;
    }
    EXPECT_FALSE(findDatDirectory(root_.path())) << "three levels down is too far";
}

TEST_F(DatDirectoryTest, ignoresLetterCaseOfFilesAndDirectories) {
    fs::rename(game_ / "client_portal.dat", game_ / "Client_Portal.DAT");
    const Result<DatDirectory> found = findDatDirectory(root_ / "games/turbine/ASHERON'S CALL");
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_EQ(found->directory, game_);
    EXPECT_EQ(found->paths.portal, game_ / "Client_Portal.DAT");
}

TEST_F(DatDirectoryTest, namesAMissingFileTheOtherOneAndEachPathTried) {
    fs::remove(game_ / "client_cell_1.dat");
    const std::string error = errorFor(game_.parent_path());
    EXPECT_TRUE(contains(error, "client_cell_1.dat is missing")) << error;
    EXPECT_TRUE(contains(error, (game_ / "client_portal.dat").string())) << error;
    EXPECT_TRUE(contains(error, game_.parent_path().string() + ",")) << error;
    EXPECT_TRUE(contains(error, "client_highres.dat (")) << error;
    EXPECT_TRUE(contains(error, "client_local_English.dat (")) << error;
    EXPECT_FALSE(contains(error, "\n")) << error;
}

TEST_F(DatDirectoryTest, explainsAWrongDirectory) {
    const std::string error = errorFor(root_ / "Games/Turbin");
    EXPECT_TRUE(contains(error, "Did you mean 'Turbine'?")) << error;
    fs::create_directories(root_ / "empty");
    EXPECT_TRUE(
        contains(errorFor(root_ / "empty"), "client_portal.dat is missing; client_cell_1.dat is missing"));
    EXPECT_TRUE(contains(errorFor(""), "is empty"));
}

TEST_F(DatDirectoryTest, namesOlderFiles) {
    fs::create_directories(root_ / "old");
    putText(root_ / "old/portal.dat", "x");
    putText(root_ / "old/cell.dat", "x");
    EXPECT_TRUE(contains(errorFor(root_ / "old"), "older than the end of retail"));
}

TEST_F(DatDirectoryTest, aTruncatedFileIsNamedWhenTheWorldOpens) {
    const fs::path world = root_ / "world";
    ASSERT_TRUE(worlds::writeGeneratedWorld({worlds::GeneratedKind::Town, 4, 1}, world));
    fs::resize_file(world / "client_cell_1.dat", fs::file_size(world / "client_cell_1.dat") / 3);
    fs::remove(world / "world.json");
    const Result<WorldSource> source = openWorldSource(world.string());
    ASSERT_FALSE(source);
    EXPECT_TRUE(contains(source.error().message(), "client_cell_1.dat")) << source.error().message();
}

/// A file system in memory.
struct ImaginarySystem {
    std::set<fs::path> directories;
    std::map<std::string, std::string> variables;
    std::vector<fs::path> drives;

    void add(const fs::path& path) {
        for (fs::path p = path; p.has_relative_path(); p = p.parent_path())
            directories.insert(p);
    }
    [[nodiscard]] SystemView view() const {
        return {"/home/u",
                [this](const char* name) {
                    const auto found = variables.find(name);
                    return found == variables.end() ? std::string() : found->second;
                },
                [this](const fs::path& path) {
                    std::vector<fs::path> entries;
                    for (const fs::path& directory : directories)
                        if (directory.parent_path() == path)
                            entries.push_back(directory);
                    return entries;
                },
                [this](const fs::path& path) { return directories.contains(path); }, drives};
    }
};

TEST(KnownGameDirectories, areThoseOfInstallersOnEveryDrive) {
    ImaginarySystem system;
    const fs::path first = "/c/Turbine/Asheron's Call", second = "/d/Games/AC";
    system.drives = {"/c", "/d"};
    for (const fs::path& path : {first, second})
        system.add(path);
    EXPECT_EQ(knownGameDirectories(system.view()), (std::vector<fs::path>{first, second}));
}

TEST(KnownGameDirectories, areThoseOfInstallersInWinePrefixes) {
    ImaginarySystem system;
    const fs::path own = "/prefix/drive_c/Turbine/Asheron's Call";
    const fs::path wine = "/home/u/.wine/drive_c/Program Files (x86)/Microsoft Games/Asheron's Call";
    const fs::path lutris = "/home/u/Games/asheron/drive_c/Program Files/Turbine/Asheron's Call";
    const fs::path steam = "/home/u/.local/share/Steam/steamapps/compatdata/77/pfx/drive_c/Asheron's Call";
    for (const fs::path& path : {own, wine, lutris, steam})
        system.add(path);
    system.variables["WINEPREFIX"] = "/prefix";
    EXPECT_EQ(knownGameDirectories(system.view()), (std::vector<fs::path>{own, wine, lutris, steam}));
    EXPECT_TRUE(knownGameDirectories(ImaginarySystem().view()).empty());
}

} // namespace
} // namespace limen::engine
