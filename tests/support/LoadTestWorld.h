#pragma once

#include "dat/Archive.h"
#include "support/TestWorld.h"
#include "world/Loader.h"

#include <gtest/gtest.h>

#include <cstdlib>

// Header-only, for tests that link limen::world.
namespace limen::test {

/// A new directory, removed with its content.
class TempDir {
public:
    TempDir() {
        std::string name = (std::filesystem::temp_directory_path() / "limen-test-XXXXXX").string();
        path_ = mkdtemp(name.data()) != nullptr ? name : std::string();
        EXPECT_FALSE(path_.empty()) << "no temporary directory can be made";
    }
    ~TempDir() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Writes the world to files and loads the blocks around its home. A failure fails the test and yields an
/// empty world.
[[nodiscard]] inline world::World loadTestWorld(TestWorld& source, const world::LoadOptions& options = {},
                                                const world::MovingEntries& moving = {}) {
    const TempDir directory;
    const Result<void> written = source.write(directory.path());
    EXPECT_TRUE(written) << (written ? "" : written.error().message());
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    if (!archive) {
        ADD_FAILURE() << archive.error().message();
        return {};
    }
    Result<world::World> loaded = world::loadWorld(*archive, source.home(), options, moving);
    if (!loaded) {
        ADD_FAILURE() << loaded.error().message();
        return {};
    }
    return std::move(*loaded);
}

/// Metres of the world's frame from block-local ones.
[[nodiscard]] inline Vec3 toGlobal(const TestWorld& source, const Vec3& local) {
    return local + Vec3(source.home().x * world::kBlockSize, source.home().y * world::kBlockSize, 0.0);
}

/// All findings as text, one per line, for failure messages and searches.
[[nodiscard]] inline std::string findingsOf(const world::World& world) {
    std::string text;
    for (const world::Finding& finding : world.findings) {
        char id[16];
        std::snprintf(id, sizeof id, "%08X ", finding.record);
        text += id + finding.what + "\n";
    }
    return text;
}

} // namespace limen::test
