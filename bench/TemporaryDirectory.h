#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <string_view>
#include <unistd.h>

namespace limen::bench {

/// The name of a directory of this process in the system's temporary directory. The constructor does not make
/// it; the destructor removes it with its content.
class TemporaryDirectory {
public:
    explicit TemporaryDirectory(std::string_view name) {
        std::error_code error;
        path_ = std::filesystem::temp_directory_path(error) / fmt::format("limen-{}-{}", name, ::getpid());
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
    ~TemporaryDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace limen::bench
