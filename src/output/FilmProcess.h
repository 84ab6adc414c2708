#pragma once

#include "core/Error.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limen::output {

/// The way to get ffmpeg on this system, an imperative clause.
extern const char* const kFfmpegAdvice;

/// A running ffmpeg, its input, its messages and the film that it writes.
class FilmProcess {
public:
    /// Starts ffmpeg in a group of its own: Ctrl-C reaches this program alone, which then ends ffmpeg. The name of the output
    /// is added to `arguments`. Errors: a file beside `path` or the process cannot be made.
    [[nodiscard]] static Result<FilmProcess> start(const std::filesystem::path& ffmpeg,
                                                   const std::filesystem::path& path,
                                                   std::vector<std::string> arguments);
    ~FilmProcess(); ///< ends ffmpeg and drops the film
    FilmProcess(FilmProcess&&) noexcept;
    FilmProcess& operator=(FilmProcess&&) noexcept;

    /// Writes all bytes to ffmpeg's input. False: ffmpeg has ended.
    [[nodiscard]] bool write(std::span<const std::byte> bytes);
    /// Ends the input and waits. True if ffmpeg succeeded.
    [[nodiscard]] bool wait();
    /// True if the film has no bytes. Requires that ffmpeg has ended.
    [[nodiscard]] bool isEmpty() const;
    /// The last line with text that ffmpeg printed.
    [[nodiscard]] std::string lastMessage() const;
    /// Gives the film its name. Requires that ffmpeg has succeeded.
    [[nodiscard]] Result<void> keep();

private:
    struct State;
    explicit FilmProcess(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace limen::output
