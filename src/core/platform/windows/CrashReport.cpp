#include "core/platform/CrashReport.h"

#include "core/platform/windows/Text.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <string>
#include <windows.h>

namespace limen::platform {
namespace {

// A filter of exceptions has no argument through which it could reach an object.
constinit std::atomic<const char*> crashingProgram{nullptr};

void printPlace(const void* address) {
    HMODULE module = nullptr;
    std::array<wchar_t, MAX_PATH> name{};
    if (GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS |
                               GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                           static_cast<LPCWSTR>(address), &module) == 0 ||
        GetModuleFileNameW(module, name.data(), static_cast<DWORD>(name.size())) == 0)
        std::fprintf(stderr, "  %p, in code that was made while the program ran\n", address);
    else
        std::fprintf(stderr, "  %s+0x%llx\n", narrowText(name.data()).c_str(),
                     static_cast<unsigned long long>(reinterpret_cast<std::uintptr_t>(address) -
                                                     reinterpret_cast<std::uintptr_t>(module)));
}

LONG WINAPI onCrash(EXCEPTION_POINTERS* exception) {
    std::fprintf(stderr, "%s: crashed by exception 0x%08lx; please report these lines\n",
                 crashingProgram.load(), exception->ExceptionRecord->ExceptionCode);
    printPlace(exception->ExceptionRecord->ExceptionAddress);
    std::array<void*, 48> calls{};
    const USHORT count = CaptureStackBackTrace(0, static_cast<DWORD>(calls.size()), calls.data(), nullptr);
    std::fprintf(stderr, "%s: calls\n", crashingProgram.load());
    for (USHORT i = 0; i < count; ++i)
        printPlace(calls[i]);
    std::fflush(stderr);
    return EXCEPTION_CONTINUE_SEARCH;
}

} // namespace

void reportCrashes(const char* program) {
    crashingProgram = program;
    SetUnhandledExceptionFilter(onCrash);
}

} // namespace limen::platform
