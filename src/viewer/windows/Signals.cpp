#include "viewer/Signals.h"

#include <atomic>
#include <windows.h>

namespace limen::viewer {
namespace {

constexpr int kHangUp = 1, kInterrupt = 2, kTerminate = 15; // numbers of SIGHUP, SIGINT, SIGTERM

// A handler of the console has no argument through which it could reach an object.
constinit std::atomic<int> consoleSignal{0};

/// Runs on a thread of its own. A second event ends the program, as a second signal does.
BOOL WINAPI onConsoleEvent(DWORD event) {
    const bool isClosing = event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT;
    int none = 0;
    const int signal = isClosing ? kHangUp : event == CTRL_C_EVENT ? kInterrupt : kTerminate;
    if (!consoleSignal.compare_exchange_strong(none, signal))
        TerminateProcess(GetCurrentProcess(), static_cast<UINT>(exitCodeOf(consoleSignal)));
    if (isClosing)
        Sleep(INFINITE); // the system ends the process as soon as this returns
    return TRUE;
}

} // namespace

struct Signals::State {};

Signals::Signals() {
    consoleSignal = 0;
    SetConsoleCtrlHandler(onConsoleEvent, TRUE); // called before the handlers that are there
}

Signals::~Signals() {
    SetConsoleCtrlHandler(onConsoleEvent, FALSE);
}

std::optional<int> Signals::arrived() {
    if (const int signal = consoleSignal; signal != 0)
        arrived_ = signal;
    return arrived_;
}

std::string_view nameOfSignal(int signal) {
    return signal == kInterrupt ? "Ctrl-C" : signal == kTerminate ? "Ctrl-Break" : "the end of the session";
}

} // namespace limen::viewer
