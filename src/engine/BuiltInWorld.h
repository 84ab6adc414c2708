#pragma once

#include "core/Error.h"

#include <filesystem>
#include <functional>
#include <string>

namespace limen::engine {

/// Writes the world's files into an existing, empty directory.
using WorldWriter = std::function<Result<void>(const std::filesystem::path&)>;

/// The directory that holds the built-in world's files; removes it again if it was only borrowed for this
/// run.
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

/// Where caches go: $XDG_CACHE_HOME, else $HOME/.cache, with "limen" added; empty if neither is an absolute
/// path.
[[nodiscard]] std::filesystem::path cacheRoot();

/// A key that changes when the program does: a hash of the running program's file.
[[nodiscard]] std::string programKey();

/// The directory `root`/`key` with the built-in world in it, written there if it is not yet. Written to a
/// directory of another name first and renamed, so that processes that start at once do not meet half a
/// world. The oldest others under `root` beyond a few are removed. Without a root that can be written, a
/// temporary directory. Errors: the writer's; no place at all to write.
[[nodiscard]] Result<BuiltInWorld> openBuiltInWorld(const std::filesystem::path& root, const std::string& key,
                                                    const WorldWriter& write);

/// Throws the cached world away, so that the next open writes it anew.
void discardBuiltInWorld(const BuiltInWorld& world);

} // namespace limen::engine
