#pragma once

#include "support/TemporaryDirectory.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace limen::test {

/// The result of a run of the program.
struct ProgramRun {
    int exit = -1; ///< 124: timeout; -1: killed by a signal
    std::string out, err;
    [[nodiscard]] std::size_t errorLines() const {
        return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n'));
    }
};

/// Runs the program (LIMEN_PROGRAM) with its own cache and working directory and without a display.
class ProgramRunner {
public:
    [[nodiscard]] ProgramRun run(const std::vector<std::string>& arguments) const {
        std::string command = "cd " + quoted(work_.path()) +
                              " && env -u DISPLAY -u WAYLAND_DISPLAY XDG_CACHE_HOME=" + quoted(cache()) +
                              " timeout -k 5 120 " + quoted(LIMEN_PROGRAM);
        for (const std::string& argument : arguments)
            command += " " + quoted(argument);
        command += " >" + quoted(streams_ / "out") + " 2>" + quoted(streams_ / "err") + " </dev/null";
        const int status = std::system(command.c_str());
        ProgramRun result;
        result.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        result.out = getText(streams_ / "out");
        result.err = getText(streams_ / "err");
        return result;
    }
    /// The program's working directory.
    [[nodiscard]] const TemporaryDirectory& work() const { return work_; }
    /// The cache, shared by the tests of one run so that the world is written once.
    [[nodiscard]] static std::filesystem::path cache() { return std::filesystem::path(LIMEN_TEST_CACHE); }

private:
    static std::string quoted(const std::string& text) {
        std::string result = "'";
        for (const char c : text)
            result += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return result + "'";
    }
    TemporaryDirectory work_, streams_;
};

} // namespace limen::test
