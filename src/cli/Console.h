#pragma once

#include "core/Error.h"
#include "core/Interrupt.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace limen::cli {

/// Exit codes of every verb.
enum class Exit : int {
    Done = 0,
    Finding = 1,    ///< the verb found a fault that it searches for: a missed target, a wrong pixel
    Impossible = 2, ///< the verb failed
    Interrupted = 3 ///< the verb stopped after a signal; the process then ends by that signal
};

/// The terminal of a verb: data on standard output, everything else on standard error, and Ctrl-C.
class Console {
public:
    explicit Console(std::FILE* out = stdout, std::FILE* err = stderr, Interrupt interrupt = {});

    /// Writes data unchanged; at once if standard output is a terminal.
    void data(std::string_view text) const;
    /// Writes one line for a person.
    void note(std::string_view text) const;
    /// Writes one line: an output, with its full path, and its content, e.g. "640x360 pixels".
    void wrote(const std::filesystem::path& path, std::string_view content = {}) const;
    /// Writes one line with the error. Control characters and line breaks are replaced by blanks.
    void error(const Error& error) const;
    /// Returns false if standard output lost data (a full disk, a closed pipe).
    [[nodiscard]] bool flush() const;
    [[nodiscard]] std::FILE* err() const { return err_; }
    /// A long verb calls defer(), reads isRequested() between units, and returns Exit::Interrupted.
    [[nodiscard]] const Interrupt& interrupt() const { return interrupt_; }
    /// True if standard error is a terminal.
    [[nodiscard]] bool isTerminal() const;

private:
    std::FILE* out_;
    std::FILE* err_;
    Interrupt interrupt_;
    bool isOutTerminal_;
};

/// A progress bar on the terminal's last line, shown after one second of work. Invisible if standard error is
/// not a terminal.
class Progress {
public:
    Progress(const Console& console, std::string_view title, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step(std::size_t done);

private:
    using Clock = std::chrono::steady_clock;
    const Console& console_;
    std::string title_;
    std::size_t total_;
    Clock::time_point start_ = Clock::now(), drawn_{};
    bool shown_ = false;
};

/// A line such as "loading the world ... 3 s" on the terminal, shown after one second of a step without a
/// count. Invisible if standard error is not a terminal. Nothing else may write while it exists.
class Waiting {
public:
    Waiting(const Console& console, std::string title);
    ~Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

private:
    void show();
    const Console& console_;
    const std::string title_;
    std::mutex lock_;
    std::condition_variable ended_;
    bool isEnding_ = false; ///< under lock_
    std::thread thread_;    ///< last: uses the members above; not started without a terminal
};

} // namespace limen::cli
