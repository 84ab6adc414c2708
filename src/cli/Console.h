#pragma once

#include "core/Error.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string_view>

namespace limen::cli {

/// Exit codes of every verb.
enum class Exit : int {
    Done = 0,
    Finding = 1,    ///< the verb looked for something (a missed target, a disagreement) and found it
    Impossible = 2, ///< it could not do what was asked
};

/// Where a verb talks: data on standard output, everything else on standard error.
class Console {
public:
    explicit Console(std::FILE* out = stdout, std::FILE* err = stderr) : out_(out), err_(err) {}

    /// Data, as it is.
    void data(std::string_view text) const;
    /// One line for a person.
    void note(std::string_view text) const;
    /// One line that says why it could not be done; control characters and line breaks are replaced.
    void error(const Error& error) const;
    /// False if standard output did not take everything (a full disk, a closed pipe).
    [[nodiscard]] bool flush() const;
    [[nodiscard]] std::FILE* err() const { return err_; }
    /// True if standard error is a terminal.
    [[nodiscard]] bool isTerminal() const;

private:
    std::FILE* out_;
    std::FILE* err_;
};

/// A bar on the terminal's last line for work that takes more than a second; nothing where standard error is
/// no terminal.
class Progress {
public:
    Progress(const Console& console, std::string_view what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step(std::size_t done);

private:
    using Clock = std::chrono::steady_clock;
    const Console& console_;
    std::string what_;
    std::size_t total_;
    Clock::time_point start_ = Clock::now(), drawn_{};
    bool shown_ = false;
};

} // namespace limen::cli
