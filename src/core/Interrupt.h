#pragma once

namespace limen {

/// The signals that end a program early: SIGINT (Ctrl-C), SIGTERM and SIGHUP. A signal that was ignored when
/// the program started, as under nohup, stays ignored.
///
/// At first a signal ends the process at once. A verb that can stop between two units of its work calls
/// `defer`, and from then on reads `signal` between units. A second signal ends the process at once.
class Interrupt {
public:
    /// Watches no signal: `signal` is always 0. For tests.
    Interrupt() = default;
    /// Watches the signals of this process. Called once, by `main`.
    [[nodiscard]] static Interrupt install();

    /// From now on the first signal only sets `signal`. Call it at the head of a loop that reads `signal`.
    void defer() const;
    /// The number of the first signal since `install`; 0: none. Safe on every thread.
    [[nodiscard]] int signal() const;
    /// True if there was a signal: finish the unit, save the work, and return.
    [[nodiscard]] bool isRequested() const { return signal() != 0; }
    /// Ends the process by the signal that came, so that a shell sees 128 plus its number and stops a script.
    /// Requires a signal.
    [[noreturn]] void die() const;

private:
    bool installed_ = false;
};

/// While an object of this class exists, no signal ends the process: a temporary file is removed or renamed
/// first. Its destructor ends the process if a signal waits. Hold it for a short time only.
class UninterruptedWrite {
public:
    UninterruptedWrite();
    ~UninterruptedWrite();
    UninterruptedWrite(const UninterruptedWrite&) = delete;
    UninterruptedWrite& operator=(const UninterruptedWrite&) = delete;
};

} // namespace limen
