#include "core/platform/CrashReport.h"

#include "core/platform/InterruptSource.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <dlfcn.h>
#include <execinfo.h>
#include <sys/prctl.h>
#include <ucontext.h>
#include <unistd.h>

namespace limen::platform {
namespace {

// A handler of signals has no argument through which it could reach an object.
constinit const char* crashingProgram = nullptr;
constinit std::atomic<bool> isReporting{false};

/// The handler's stack in the thread that called reportCrashes: the fault may be that its own is exhausted.
constinit std::array<std::byte, 64 * 1024> handlerStack{};

constexpr std::array kFaults{SIGSEGV, SIGBUS, SIGILL, SIGFPE};
constexpr unsigned kLongest =
    10; ///< seconds; a call of the report may wait for a lock of the thread that crashed

template <typename... Values>
void printLine(const char* format, Values... values) {
    std::array<char, 512> line{};
    const int length = std::snprintf(line.data(), line.size(), format, values...);
    const std::size_t size = std::min(static_cast<std::size_t>(std::max(length, 0)), line.size() - 1);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), size);
}

void printPlace(const void* address) {
    Dl_info found{};
    if (::dladdr(address, &found) == 0 || found.dli_fname == nullptr)
        printLine("  %p, in code that was made while the program ran\n", address);
    else
        printLine("  %s+0x%zx\n", found.dli_fname,
                  reinterpret_cast<std::uintptr_t>(address) -
                      reinterpret_cast<std::uintptr_t>(found.dli_fbase));
}

/// The instruction that was interrupted, or null on a processor that is not known here.
const void* placeOf([[maybe_unused]] const void* context) {
#if defined(__x86_64__)
    return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
    return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(context)->uc_mcontext.pc);
#else
    return nullptr;
#endif
}

/// Not all that it calls is allowed in a handler. Faults are blocked in it, so a second one of this thread ends the process, and the
/// first lines are written by then. Another thread that faults meanwhile waits for the end.
void onCrash(int signal, siginfo_t* info, void* context) {
    while (isReporting.exchange(true))
        ::pause();
    ::alarm(kLongest);
    std::array<char, 16> thread{};
    ::prctl(PR_GET_NAME, thread.data());
    printLine("%s: crashed by signal %d at address %p in thread %s; please report these lines\n",
              crashingProgram, signal, info->si_addr, thread.data());
    if (const void* place = placeOf(context); place != nullptr)
        printPlace(place);
    std::array<void*, 48> calls{};
    const int count = ::backtrace(calls.data(), static_cast<int>(calls.size()));
    printLine("%s: calls\n", crashingProgram);
    for (int i = 0; i < count; ++i)
        printPlace(calls[static_cast<std::size_t>(i)]);
    endBySignal(signal);
}

} // namespace

void reportCrashes(const char* program) {
    crashingProgram = program;
    std::array<void*, 1> first{};
    ::backtrace(first.data(), 1); // a handler should not load libraries
    const stack_t stack{.ss_sp = handlerStack.data(), .ss_flags = 0, .ss_size = handlerStack.size()};
    stack_t present{};
    if (::sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) != 0)
        ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = onCrash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    ::sigemptyset(&action.sa_mask);
    for (const int signal : kFaults)
        ::sigaddset(&action.sa_mask, signal);
    for (const int signal : kFaults) {
        struct sigaction before {};
        if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
            ::sigaction(signal, &action, nullptr);
    }
}

} // namespace limen::platform
