#include "output/Film.h"

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
#include <string>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace limen::output {
namespace {

constexpr int kFilmDescriptor = 3; ///< of ffmpeg's output in the child process

/// Arguments of ffmpeg between input and output.
std::vector<std::string> encodingOf(FilmFormat format) {
    const std::string even = "crop=trunc(iw/2)*2:trunc(ih/2)*2";
    switch (format) {
    case FilmFormat::Mp4:
        return {"-vf",  even, "-c:v",    "libx264", "-pix_fmt", "yuv420p",
                "-crf", "20", "-preset", "medium",  "-f",       "mp4"};
    case FilmFormat::Webm:
        return {"-vf", even,   "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf",
                "32",  "-b:v", "0",    "-row-mt",    "1",        "-f",      "webm"};
    case FilmFormat::Gif:
        return {"-vf",
                "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
                "-loop",
                "0",
                "-f",
                "gif"};
    case FilmFormat::Webp:
        return {"-c:v", "libwebp_anim", "-quality", "70", "-compression_level",
                "4",    "-loop",        "0",        "-f", "webp"};
    }
    return {};
}

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

Result<FilmFormat> filmFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 4> kEndings{".mp4", ".webm", ".gif", ".webp"};
    for (std::size_t i = 0; i < kEndings.size(); ++i)
        if (ending == kEndings[i])
            return static_cast<FilmFormat>(i);
    return fail(ErrorCode::BadArgument, path.string(),
                fmt::format("{} names no known film format; use .mp4, .webm, .gif or .webp",
                            ending.empty() ? "a name without ending" : "the ending " + ending));
}

Result<std::filesystem::path> findFfmpeg(std::string_view searchPath) {
    for (std::size_t begin = 0; begin <= searchPath.size();) {
        const std::size_t end = std::min(searchPath.find(':', begin), searchPath.size());
        const std::filesystem::path program =
            std::filesystem::path(searchPath.substr(begin, end - begin)) / "ffmpeg";
        if (program.is_absolute() && ::access(program.c_str(), X_OK) == 0)
            return program;
        begin = end + 1;
    }
    return fail(ErrorCode::NotFound, "ffmpeg",
                "is not installed, and films need it; install the package ffmpeg, or write pictures with -o "
                "DIR");
}

struct Film::Process {
    std::filesystem::path path;
    std::uint32_t width = 0, height = 0;
    pid_t id = -1;
    int frames = -1;   ///< socket to ffmpeg's standard input
    int film = -1;     ///< ffmpeg's output
    int messages = -1; ///< ffmpeg's standard error
    std::size_t count = 0;

    Process() = default;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (id > 0)
            (void)::kill(id, SIGKILL);
        (void)wait();
        closeIfOpen(film);
        closeIfOpen(messages);
    }

    /// Ends the input and waits. Returns true if ffmpeg succeeded.
    bool wait() {
        closeIfOpen(frames);
        int status = 0;
        while (id > 0 && ::waitpid(id, &status, 0) < 0 && errno == EINTR) {
        }
        const bool isDone = id > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
        id = -1;
        return isDone;
    }

    [[nodiscard]] Failure failure() const {
        const std::string reason = lastLine(messages);
        return fail(ErrorCode::Unreadable, path.string(),
                    fmt::format("ffmpeg could not write the film: {}",
                                reason.empty() ? "it gave no reason" : reason));
    }

    bool spawn(const std::filesystem::path& ffmpeg, std::vector<std::string> arguments, int input) {
        std::vector<char*> pointers;
        for (std::string& argument : arguments)
            pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawnattr_t attributes;
        (void)::posix_spawn_file_actions_init(&actions);
        (void)::posix_spawnattr_init(&attributes);
        // A group of its own: Ctrl-C reaches this program alone, which then ends ffmpeg.
        (void)::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        (void)::posix_spawn_file_actions_adddup2(&actions, input, 0);
        (void)::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
        (void)::posix_spawn_file_actions_adddup2(&actions, messages, 2);
        (void)::posix_spawn_file_actions_adddup2(&actions, film, kFilmDescriptor);
        const int error = ::posix_spawn(&id, ffmpeg.c_str(), &actions, &attributes, pointers.data(), environ);
        (void)::posix_spawn_file_actions_destroy(&actions);
        (void)::posix_spawnattr_destroy(&attributes);
        if (error != 0)
            id = -1;
        errno = error;
        return error == 0;
    }
};

Film::Film(std::unique_ptr<Process> process) : process_(std::move(process)) {}
Film::~Film() = default;
Film::Film(Film&&) noexcept = default;
Film& Film::operator=(Film&&) noexcept = default;

Result<Film> Film::start(const std::filesystem::path& ffmpeg, const std::filesystem::path& path,
                         std::uint32_t width, std::uint32_t height, double framesPerSecond) {
    const Result<FilmFormat> format = filmFormatOf(path);
    if (!format)
        return Failure(format.error());
    if (Result<void> writable = checkWritable(path); !writable)
        return Failure(writable.error());
    if (width < 2 || height < 2)
        return fail(ErrorCode::BadArgument, path.string(),
                    "a film needs at least 2x2 pixels; choose a larger --size");
    auto process = std::make_unique<Process>();
    process->path = path;
    process->width = width;
    process->height = height;
    const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
    process->film = openNameless(directory);
    process->messages = openNameless(directory);
    std::array<int, 2> ends{-1, -1};
    if (process->film < 0 || process->messages < 0 ||
        ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return fail(ErrorCode::Unreadable, path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    process->frames = ends[0];
    std::vector<std::string> arguments{"ffmpeg",       "-nostdin",
                                       "-hide_banner", "-loglevel",
                                       "error",        "-y",
                                       "-f",           "rawvideo",
                                       "-pix_fmt",     "rgb24",
                                       "-s",           fmt::format("{}x{}", width, height),
                                       "-framerate",   fmt::format("{}", framesPerSecond),
                                       "-i",           "pipe:0"};
    for (std::string& argument : encodingOf(*format))
        arguments.push_back(std::move(argument));
    arguments.push_back(fmt::format("/proc/self/fd/{}", kFilmDescriptor));
    const bool isStarted = process->spawn(ffmpeg, std::move(arguments), ends[1]);
    const int error = errno;
    closeIfOpen(ends[1]);
    if (!isStarted)
        return fail(ErrorCode::Unreadable, ffmpeg.string(),
                    fmt::format("cannot be started: {}", std::strerror(error)));
    return Film(std::move(process));
}

Result<void> Film::add(const Picture& frame) {
    Process& process = *process_;
    if (frame.width != process.width || frame.height != process.height)
        return fail(ErrorCode::BadArgument, process.path.string(),
                    fmt::format("frame {} has another size than the first; give one --size for all frames",
                                process.count));
    std::span<const std::uint8_t> rest = frame.rgb;
    while (!rest.empty()) {
        // MSG_NOSIGNAL: an ffmpeg that has ended gives an error here, not a SIGPIPE.
        const ssize_t sent = ::send(process.frames, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0) {
            (void)process.wait();
            return process.failure();
        }
        rest = rest.subspan(static_cast<std::size_t>(sent));
    }
    ++process.count;
    return {};
}

Result<void> Film::finish() {
    Process& process = *process_;
    if (process.count == 0)
        return fail(ErrorCode::BadArgument, process.path.string(), "a film without frames is not written");
    if (!process.wait())
        return process.failure();
    struct stat status {};
    if (::fstat(process.film, &status) != 0 || status.st_size == 0)
        return process.failure();
    const auto size = static_cast<std::size_t>(status.st_size);
    void* bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, process.film, 0);
    if (bytes == MAP_FAILED)
        return fail(ErrorCode::Unreadable, process.path.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    Result<void> written = writeFile(process.path, std::span(static_cast<const std::byte*>(bytes), size));
    (void)::munmap(bytes, size);
    return written;
}

} // namespace limen::output
