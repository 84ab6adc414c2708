#include "core/platform/Process.h"

#include "core/platform/posix/MemInfo.h"

#include <cerrno>
#include <cstring>
#include <dlfcn.h>
#include <fstream>
#include <iterator>
#include <link.h>
#include <unistd.h>

namespace limen::platform {
int processId() {
    return ::getpid();
}

std::filesystem::path programPath() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error);
}

std::filesystem::path programBytes() {
    // The name is empty for the program itself, and that of the file for a shared library.
    Dl_info info{};
    void* loaded = nullptr;
    if (dladdr1(reinterpret_cast<const void*>(&programBytes), &info, &loaded, RTLD_DL_LINKMAP) != 0 &&
        loaded != nullptr)
        if (const char* name = static_cast<const link_map*>(loaded)->l_name; name != nullptr && *name != '\0')
            return name;
    return "/proc/self/exe";
}

std::string becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{program.c_str()};
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    argv.push_back(nullptr);
    ::execv(program.c_str(), const_cast<char* const*>(argv.data()));
    return std::strerror(errno);
}

Memory systemMemory() {
    std::ifstream file("/proc/meminfo");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return {memoryIn(text, "MemTotal:"), memoryIn(text, "MemAvailable:")};
}

} // namespace limen::platform
