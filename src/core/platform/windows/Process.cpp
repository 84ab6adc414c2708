#include "core/platform/Process.h"

#include "core/platform/windows/Text.h"

#include <cstdlib>
#include <windows.h>

namespace limen::platform {

int processId() {
    return static_cast<int>(GetCurrentProcessId());
}

std::filesystem::path programPath() {
    constexpr std::size_t kLongest = 32768; // of any path
    std::wstring path(kLongest, L'\0');
    path.resize(GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

/// Windows does not let anyone replace the file of a running program.
std::filesystem::path programBytes() {
    return programPath();
}

std::string becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{program.string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::wstring line = commandLine(all);
    STARTUPINFOW startup{};
    startup.cb = sizeof startup;
    PROCESS_INFORMATION process{};
    if (CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &startup,
                       &process) == 0)
        return errorText(GetLastError());
    WaitForSingleObject(process.hProcess, INFINITE);
    DWORD code = 1;
    GetExitCodeProcess(process.hProcess, &code);
    std::exit(static_cast<int>(code));
}

Memory systemMemory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    if (GlobalMemoryStatusEx(&status) == 0)
        return {};
    return {status.ullTotalPhys, status.ullAvailPhys};
}

} // namespace limen::platform
