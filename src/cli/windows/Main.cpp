#include "cli/Verbs.h"
#include "cli/windows/ConsoleWindow.h"
#include "core/platform/CrashReport.h"
#include "core/platform/Files.h"
#include "core/platform/windows/Text.h"
#include "engine/UserFiles.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <io.h>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

/// Files and streams have the bytes that were written, as on other systems.
void setBinary() {
    _fmode = _O_BINARY;
    for (std::FILE* file : {stdin, stdout, stderr})
        if (_fileno(file) >= 0)
            _setmode(_fileno(file), _O_BINARY);
    // Without a buffer, the C library writes single bytes to a console, which then shows no letter beyond ASCII.
    for (std::FILE* file : {stdout, stderr})
        (void)std::setvbuf(file, nullptr, _IOFBF, kBufferBytes);
}

limen::cli::Exit run(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    const limen::cli::Console console(stdout, stderr, limen::Interrupt::install());
    const limen::cli::Exit exit = limen::cli::runProgram(static_cast<int>(argv.size()), argv.data(), console);
    if (exit == limen::cli::Exit::Interrupted && console.interrupt().isRequested())
        console.interrupt().die();
    return exit;
}

/// The first name that cannot be text: an argument, or the current directory; empty if there is none.
std::wstring noText(int count, wchar_t** texts) {
    for (int i = 1; i < count; ++i)
        if (!limen::platform::isWellFormed(texts[i]))
            return texts[i];
    std::error_code error;
    const std::filesystem::path directory = std::filesystem::current_path(error);
    return limen::platform::isText(directory) ? std::wstring() : directory.native();
}

} // namespace

extern "C" int wmain(int count, wchar_t** texts) {
    limen::platform::reportCrashes("limen");
    std::vector<std::string> arguments;
    for (int i = 0; i < count; ++i)
        arguments.push_back(limen::platform::narrowText(texts[i]));
    setBinary();
    if (const std::wstring name = noText(count, texts); !name.empty()) {
        limen::cli::Console(stdout, stderr, limen::Interrupt::install())
            .error({limen::ErrorCode::Unsupported, "'" + limen::platform::narrowText(name) + "'",
                    limen::platform::kNoText});
        return static_cast<int>(limen::cli::Exit::Impossible);
    }
    const bool opensWindow = arguments.size() <= 1 || arguments[1] == "view";
    if (!opensWindow || !limen::cli::isWithoutReader()) {
        const limen::cli::ConsoleWindow console;
        return static_cast<int>(run(arguments));
    }
    const std::filesystem::path messages = limen::engine::cacheRoot().parent_path() / "messages.txt";
    limen::cli::leaveConsole(messages);
    const limen::cli::Exit exit = run(arguments);
    if (exit == limen::cli::Exit::Impossible)
        limen::cli::showMessages(messages);
    return static_cast<int>(exit);
}
