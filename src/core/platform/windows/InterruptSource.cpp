#include "core/platform/InterruptSource.h"

#include <atomic>
#include <cstdlib>
#include <windows.h>

namespace limen::platform {
namespace {

// A handler of the console has no argument through which it could reach an object.
constinit std::atomic<void (*)(int)> interruptHandler{nullptr};

/// Runs on a thread of its own. When a console closes, the system ends the process as soon as this returns, so it waits
/// for the process to end itself.
BOOL WINAPI onConsole(DWORD event) {
    constexpr int kHangUp = 1, kInterrupt = 2, kTerminate = 15;
    const bool isClosing = event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT;
    interruptHandler.load()(isClosing ? kHangUp : event == CTRL_C_EVENT ? kInterrupt : kTerminate);
    if (isClosing)
        Sleep(INFINITE);
    return TRUE;
}

} // namespace

void watchInterrupts(void (*handler)(int)) {
    interruptHandler = handler;
    SetConsoleCtrlHandler(onConsole, TRUE);
}

/// Without the clean-up of other threads' objects, as by a signal.
void endBySignal(int signal) {
    TerminateProcess(GetCurrentProcess(), static_cast<UINT>(128 + signal));
    std::abort(); // not reached
}

} // namespace limen::platform
