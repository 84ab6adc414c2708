#include "engine/BuiltInWorld.h"

#include "core/Assert.h"
#include "core/Hash.h"
#include "core/Interrupt.h"
#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "engine/UserFiles.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <span>
#include <vector>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kFiles{"client_portal.dat", "client_cell_1.dat", "world.json"};
constexpr std::size_t kKept = 6; ///< worlds that stay in the cache, one for each version of the program

bool isComplete(const fs::path& directory) {
    return std::all_of(kFiles.begin(), kFiles.end(), [&](const char* name) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(directory / name, error);
        return !error && size > 0;
    });
}

void removeQuietly(const fs::path& path) {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

/// Removes all but the kKept newest worlds; `current` and the found places (PlaceCache) always stay. Staging directories older than one hour
/// are removed, too: the process that wrote them has died.
void prune(const fs::path& root, const fs::path& current) {
    struct Old {
        fs::file_time_type time;
        fs::path path;
    };
    std::vector<Old> worlds;
    std::error_code error;
    for (fs::directory_iterator it(root, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        const fs::file_time_type time = fs::last_write_time(it->path(), ignored);
        const bool halfWritten = it->path().extension() == ".tmp";
        if (halfWritten && fs::file_time_type::clock::now() - time > std::chrono::hours(1))
            removeQuietly(it->path());
        else if (!halfWritten && it->path() != current && it->path().filename() != "places" &&
                 it->is_directory(ignored))
            worlds.push_back({time, it->path()});
    }
    std::sort(worlds.begin(), worlds.end(), [](const Old& a, const Old& b) { return a.time > b.time; });
    for (std::size_t i = kKept - 1; i < worlds.size(); ++i)
        removeQuietly(worlds[i].path);
}

/// A new, empty directory in the system's temporary directory.
Result<fs::path> temporaryDirectory() {
    const Result<fs::path> made = platform::makeTemporaryDirectory();
    if (!made)
        return fail(ErrorCode::Unreadable, made.error().where,
                    fmt::format("the built-in world cannot be written here; set {} to a writable directory",
                                userDirectoryNames().cache));
    return *made;
}

Result<BuiltInWorld> writeTemporary(const WorldWriter& write) {
    Result<fs::path> directory = temporaryDirectory();
    if (!directory)
        return Failure(directory.error());
    BuiltInWorld world(*directory, true);
    if (const Result<void> written = write(world.directory()); !written)
        return Failure(written.error());
    return world;
}

/// Writes into `staging` and renames it to `place`. False if the rename failed, for example because another
/// process wrote the same world first.
Result<bool> writeAndMove(const fs::path& staging, const fs::path& place, const WorldWriter& write) {
    const UninterruptedWrite whole;
    if (const Result<void> written = write(staging); !written) {
        removeQuietly(staging);
        return Failure(written.error());
    }
    std::error_code error;
    fs::rename(staging, place, error);
    if (error)
        removeQuietly(staging);
    return !error;
}

} // namespace

BuiltInWorld::BuiltInWorld(BuiltInWorld&& other) noexcept
    : directory_(std::move(other.directory_)), temporary_(std::exchange(other.temporary_, false)) {}

BuiltInWorld& BuiltInWorld::operator=(BuiltInWorld&& other) noexcept {
    std::swap(directory_, other.directory_);
    std::swap(temporary_, other.temporary_);
    return *this;
}

BuiltInWorld::~BuiltInWorld() {
    if (temporary_)
        removeQuietly(directory_);
}

std::string programKey() {
    Hash hash;
    std::ifstream program(platform::programBytes(), std::ios::binary);
    std::vector<char> chunk(1u << 20);
    while (program.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || program.gcount() > 0) {
        const auto got = static_cast<std::size_t>(program.gcount());
        hash.addWords(std::as_bytes(std::span(chunk).first(got)));
    }
    return fmt::format("{:016x}", hash.value());
}

Result<BuiltInWorld> openBuiltInWorld(const fs::path& root, const std::string& key,
                                      const WorldWriter& write) {
    LIMEN_ASSERT(write != nullptr, "there is a writer");
    LIMEN_ASSERT(!key.empty(), "an empty key would name the cache itself");
    if (root.empty())
        return writeTemporary(write);
    const fs::path place = root / key;
    if (isComplete(place))
        return BuiltInWorld(place, false);
    const fs::path staging = root / fmt::format("{}.{}.tmp", key, platform::processId());
    std::error_code error;
    removeQuietly(staging);
    fs::create_directories(staging, error);
    if (error)
        return writeTemporary(write);
    if (fs::exists(place, error)) // incomplete
        removeQuietly(place);
    const Result<bool> moved = writeAndMove(staging, place, write);
    if (!moved)
        return Failure(moved.error());
    if (!isComplete(place))
        return writeTemporary(write);
    prune(root, place);
    return BuiltInWorld(place, false);
}

void discardBuiltInWorld(const BuiltInWorld& world) {
    removeQuietly(world.directory());
}

} // namespace limen::engine
