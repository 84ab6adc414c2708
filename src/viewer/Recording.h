#pragma once

#include "core/Error.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace limen::viewer {

/// A file of lines that grows while the program runs. Lines reach the file after at most kFlushBytes, so that a
/// program that is killed loses little. If the disk is full, the file keeps its whole lines and the others wait
/// in memory for the next attempt.
class Recording {
public:
    static constexpr std::size_t kFlushBytes = std::size_t{16} << 10;

    Recording() = default;
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// Replaces the file. Errors: it cannot be opened.
    [[nodiscard]] Result<void> open(const std::filesystem::path& file);
    [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// Adds whole lines, each with its line end. Errors: as flush; the lines are kept.
    [[nodiscard]] Result<void> add(const std::string& lines);
    /// Writes everything that waits. Errors: the disk is full, or the file cannot be written.
    [[nodiscard]] Result<void> flush();
    /// Flushes and closes.
    [[nodiscard]] Result<void> close();
    [[nodiscard]] std::size_t lines() const { return lines_; }
    /// Lines that are in the file.
    [[nodiscard]] std::size_t savedLines() const { return saved_; }

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    std::string waiting_;
    std::int64_t length_ = 0; ///< of the file, up to the last whole line
    std::size_t lines_ = 0, saved_ = 0;
    std::size_t tried_ = 0; ///< size of waiting_ at the last failed attempt
};

} // namespace limen::viewer
