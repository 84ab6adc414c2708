#pragma once

#include <memory>
#include <optional>
#include <string_view>

namespace limen::viewer {

/// The signals that ask the program to end: SIGINT, SIGTERM, SIGHUP; on Windows the events of the console. While the object lives they are blocked and
/// wait until the frame loop reads them, so that files can be saved. Make it before any thread starts: threads
/// inherit the mask.
class Signals {
public:
    Signals();
    ~Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

    /// The number of a signal that has arrived since the object was made.
    [[nodiscard]] std::optional<int> arrived();

private:
    struct State;
    std::unique_ptr<State> state_;
    std::optional<int> arrived_;
};

/// The exit code after a signal: 128 and its number, as shells report it.
[[nodiscard]] constexpr int exitCodeOf(int signal) {
    return 128 + signal;
}
[[nodiscard]] std::string_view nameOfSignal(int signal);

} // namespace limen::viewer
