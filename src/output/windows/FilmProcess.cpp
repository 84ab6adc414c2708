#include "output/FilmProcess.h"

#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "core/platform/windows/Text.h"
#include "output/OutputFile.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <windows.h>

namespace limen::output {

const char* const kFfmpegAdvice = "put ffmpeg.exe into a directory of PATH";
namespace {

namespace fs = std::filesystem;

void closeHandle(HANDLE& handle) {
    if (handle != nullptr && handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    handle = nullptr;
}

/// A hidden file beside the film.
fs::path hiddenBeside(const fs::path& path, const char* ending) {
    return path.parent_path() / fmt::format(".limen-film-{}{}", platform::processId(), ending);
}

/// A handle that a child process may inherit.
HANDLE openForChild(const fs::path& path, DWORD access, DWORD disposition, DWORD attributes) {
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    return CreateFileW(path.c_str(), access, kShared, &inherited, disposition, attributes, nullptr);
}

/// The last line with text in a file of messages.
std::string lastLine(HANDLE file) {
    std::string text(4096, '\0');
    LARGE_INTEGER size{}, start{};
    GetFileSizeEx(file, &size);
    start.QuadPart = std::max<LONGLONG>(0, size.QuadPart - static_cast<LONGLONG>(text.size()));
    DWORD got = 0;
    if (SetFilePointerEx(file, start, nullptr, FILE_BEGIN) == 0 ||
        ReadFile(file, text.data(), static_cast<DWORD>(text.size()), &got, nullptr) == 0)
        got = 0;
    text.resize(got);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
        text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

} // namespace

struct FilmProcess::State {
    fs::path path, film; ///< ffmpeg writes to `film`, because it cannot write to a handle
    HANDLE process = nullptr;
    HANDLE frames = nullptr;   ///< pipe to ffmpeg's standard input
    HANDLE messages = nullptr; ///< ffmpeg's standard error; the file vanishes with its last handle

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (process != nullptr)
            TerminateProcess(process, 1);
        (void)wait();
        closeHandle(messages);
        std::error_code ignored;
        fs::remove(film, ignored);
    }

    bool wait() {
        closeHandle(frames);
        DWORD code = 1;
        const bool isDone = process != nullptr && WaitForSingleObject(process, INFINITE) == WAIT_OBJECT_0 &&
                            GetExitCodeProcess(process, &code) != 0 && code == 0;
        closeHandle(process);
        return isDone;
    }

    bool spawn(const fs::path& ffmpeg, const std::vector<std::string>& arguments, HANDLE input) {
        STARTUPINFOW startup{};
        startup.cb = sizeof startup;
        startup.dwFlags = STARTF_USESTDHANDLES;
        HANDLE nothing = openForChild(L"NUL", GENERIC_WRITE, OPEN_EXISTING, 0);
        startup.hStdInput = input;
        startup.hStdOutput = nothing;
        startup.hStdError = messages;
        std::wstring line = platform::commandLine(arguments);
        constexpr DWORD kFlags = CREATE_NEW_PROCESS_GROUP | CREATE_NO_WINDOW;
        PROCESS_INFORMATION made{};
        const bool isStarted = CreateProcessW(ffmpeg.c_str(), line.data(), nullptr, nullptr, TRUE, kFlags,
                                              nullptr, nullptr, &startup, &made) != 0;
        const DWORD error = GetLastError();
        closeHandle(nothing);
        closeHandle(made.hThread);
        process = made.hProcess;
        SetLastError(error);
        return isStarted;
    }
};

FilmProcess::FilmProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
FilmProcess::~FilmProcess() = default;
FilmProcess::FilmProcess(FilmProcess&&) noexcept = default;
FilmProcess& FilmProcess::operator=(FilmProcess&&) noexcept = default;

Result<FilmProcess> FilmProcess::start(const fs::path& ffmpeg, const fs::path& path,
                                       std::vector<std::string> arguments) {
    auto state = std::make_unique<State>();
    state->path = path;
    state->film = hiddenBeside(path, ".part");
    state->messages = openForChild(hiddenBeside(path, ".txt"), GENERIC_READ | GENERIC_WRITE | DELETE,
                                   CREATE_ALWAYS, FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE);
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    HANDLE input = nullptr;
    if (state->messages == INVALID_HANDLE_VALUE ||
        CreatePipe(&input, &state->frames, &inherited, 1u << 20) == 0)
        return fail(ErrorCode::Unreadable, path.string(),
                    "cannot be written: " + platform::errorText(GetLastError()));
    SetHandleInformation(state->frames, HANDLE_FLAG_INHERIT, 0); // else ffmpeg would hold its own input open
    arguments.push_back(state->film.string());
    const bool isStarted = state->spawn(ffmpeg, arguments, input);
    const DWORD error = GetLastError();
    closeHandle(input);
    if (!isStarted)
        return fail(ErrorCode::Unreadable, ffmpeg.string(),
                    "cannot be started: " + platform::errorText(error));
    return FilmProcess(std::move(state));
}

bool FilmProcess::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        constexpr std::size_t kMost = std::size_t{1} << 20;
        DWORD written = 0;
        if (WriteFile(state_->frames, bytes.data(), static_cast<DWORD>(std::min(bytes.size(), kMost)),
                      &written, nullptr) == 0)
            return false;
        bytes = bytes.subspan(written);
    }
    return true;
}

bool FilmProcess::wait() {
    return state_->wait();
}

bool FilmProcess::isEmpty() const {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(state_->film, error);
    return error || size == 0;
}

std::string FilmProcess::lastMessage() const {
    return lastLine(state_->messages);
}

Result<void> FilmProcess::keep() {
    if (!platform::replaceFile(state_->film, state_->path))
        return fail(ErrorCode::Unreadable, state_->path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    return {};
}

} // namespace limen::output
