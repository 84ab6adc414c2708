#include "output/FilmProcess.h"

#include "output/OutputFile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limen::output {

const char* const kFfmpegAdvice = "install the package ffmpeg";
namespace {

constexpr int kFilmDescriptor = 3; ///< of ffmpeg's output in the child process

/// A file in `directory` that no name leads to: it vanishes with its last descriptor.
int openNameless(const std::filesystem::path& directory) {
    const int file = ::open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (file >= 0)
        return file;
    std::string name = (directory / ".limen-film-XXXXXX").string(); // file systems without O_TMPFILE
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0)
        (void)::unlink(name.c_str());
    return named;
}

/// The last line with text in a file of messages.
std::string lastLine(int file) {
    std::string text(4096, '\0');
    const off_t size = ::lseek(file, 0, SEEK_END);
    const ssize_t got =
        ::pread(file, text.data(), text.size(), std::max<off_t>(0, size - static_cast<off_t>(text.size())));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
        text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

void closeIfOpen(int& descriptor) {
    if (descriptor >= 0)
        (void)::close(descriptor);
    descriptor = -1;
}

} // namespace

struct FilmProcess::State {
    std::filesystem::path path;
    pid_t id = -1;
    int frames = -1;   ///< socket to ffmpeg's standard input
    int film = -1;     ///< ffmpeg's output
    int messages = -1; ///< ffmpeg's standard error

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (id > 0)
            (void)::kill(id, SIGKILL);
        (void)wait();
        closeIfOpen(film);
        closeIfOpen(messages);
    }

    bool wait() {
        closeIfOpen(frames);
        int status = 0;
        while (id > 0 && ::waitpid(id, &status, 0) < 0 && errno == EINTR) {
        }
        const bool isDone = id > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
        id = -1;
        return isDone;
    }

    bool spawn(const std::filesystem::path& ffmpeg, std::vector<std::string> arguments, int input) {
        std::vector<char*> pointers;
        pointers.reserve(arguments.size() + 1);
        for (std::string& argument : arguments)
            pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawnattr_t attributes;
        (void)::posix_spawn_file_actions_init(&actions);
        (void)::posix_spawnattr_init(&attributes);
        (void)::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        (void)::posix_spawn_file_actions_adddup2(&actions, input, 0);
        (void)::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
        (void)::posix_spawn_file_actions_adddup2(&actions, messages, 2);
        (void)::posix_spawn_file_actions_adddup2(&actions, film, kFilmDescriptor);
        const int error =
            ::posix_spawn(&id, ffmpeg.c_str(), &actions, &attributes, pointers.data(), ::environ);
        (void)::posix_spawn_file_actions_destroy(&actions);
        (void)::posix_spawnattr_destroy(&attributes);
        if (error != 0)
            id = -1;
        errno = error;
        return error == 0;
    }
};

FilmProcess::FilmProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
FilmProcess::~FilmProcess() = default;
FilmProcess::FilmProcess(FilmProcess&&) noexcept = default;
FilmProcess& FilmProcess::operator=(FilmProcess&&) noexcept = default;

Result<FilmProcess> FilmProcess::start(const std::filesystem::path& ffmpeg, const std::filesystem::path& path,
                                       std::vector<std::string> arguments) {
    auto state = std::make_unique<State>();
    state->path = path;
    const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
    state->film = openNameless(directory);
    state->messages = openNameless(directory);
    std::array<int, 2> ends{-1, -1};
    if (state->film < 0 || state->messages < 0 ||
        ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return fail(ErrorCode::Unreadable, path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    state->frames = ends[0];
    arguments.push_back(fmt::format("/proc/self/fd/{}", kFilmDescriptor));
    const bool isStarted = state->spawn(ffmpeg, std::move(arguments), ends[1]);
    const int error = errno;
    closeIfOpen(ends[1]);
    if (!isStarted)
        return fail(ErrorCode::Unreadable, ffmpeg.string(),
                    fmt::format("cannot be started: {}", std::strerror(error)));
    return FilmProcess(std::move(state));
}

bool FilmProcess::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // MSG_NOSIGNAL: an ffmpeg that has ended gives an error here, not a SIGPIPE.
        const ssize_t sent = ::send(state_->frames, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool FilmProcess::wait() {
    return state_->wait();
}

bool FilmProcess::isEmpty() const {
    struct stat status {};
    return ::fstat(state_->film, &status) != 0 || status.st_size == 0;
}

std::string FilmProcess::lastMessage() const {
    return lastLine(state_->messages);
}

Result<void> FilmProcess::keep() {
    struct stat status {};
    const bool isKnown = ::fstat(state_->film, &status) == 0;
    const auto size = static_cast<std::size_t>(status.st_size);
    void* bytes = isKnown ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, state_->film, 0) : MAP_FAILED;
    if (bytes == MAP_FAILED)
        return fail(ErrorCode::Unreadable, state_->path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    Result<void> written = writeFile(state_->path, std::span(static_cast<const std::byte*>(bytes), size));
    (void)::munmap(bytes, size);
    return written;
}

} // namespace limen::output
