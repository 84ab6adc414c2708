#pragma once

#include "core/Error.h"
#include "engine/UserFiles.h"

#include <filesystem>
#include <functional>
#include <string>

namespace limen::engine {

/// Writes the world's files into an existing, empty directory.
using WorldWriter = std::function<Result<void>(const std::filesystem::path&)>;

/// The directory that holds the built-in world's files. A temporary directory is removed with this object; a
/// directory of the cache stays.
class BuiltInWorld {
public:
    BuiltInWorld(std::filesystem::path directory, bool temporary)
        : directory_(std::move(directory)), temporary_(temporary) {}
    BuiltInWorld(BuiltInWorld&& other) noexcept;
    BuiltInWorld& operator=(BuiltInWorld&& other) noexcept;
    ~BuiltInWorld();
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] bool temporary() const { return temporary_; }

private:
    std::filesystem::path directory_;
    bool temporary_ = false;
};

/// Hash of the running program's file, 16 hexadecimal digits. A rebuilt program thus never reads an older
/// cached world.
[[nodiscard]] std::string programKey();

/// Opens the built-in world in `root`/`key` and writes it first if it is missing or incomplete. The files are
/// written to a staging directory that is then renamed. Otherwise two processes that start at once could read
/// half a world. Old worlds under `root` are removed. If `root` is not writable, the world goes to a
/// temporary directory. Requires a key that is not empty. Errors: the writer's; no directory is writable.
[[nodiscard]] Result<BuiltInWorld> openBuiltInWorld(const std::filesystem::path& root, const std::string& key,
                                                    const WorldWriter& write);

/// Removes the world's files, so that the next open writes them again.
void discardBuiltInWorld(const BuiltInWorld& world);

} // namespace limen::engine
