#include "output/OutputFile.h"

#include "core/Interrupt.h"
#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "output/Encode.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <memory>

namespace limen::output {
namespace {

namespace fs = std::filesystem;

Failure refused(const fs::path& path, std::string what) {
    return fail(ErrorCode::Unreadable, path.string(), std::move(what));
}

std::string reason(int error) {
    return std::strerror(error);
}

/// The reason and the next step.
std::string notWritten(int error) {
    const char* next = platform::isDiskFull(error) ? "free some space"
                       : error == ENOENT           ? "make the directory first"
                                                   : "choose another directory, or check its permissions";
    return fmt::format("cannot be written: {}; {}", reason(error), next);
}

/// The file behind a symbolic link, so that the link itself is not replaced; else the path.
fs::path target(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_symlink(fs::symlink_status(path, ignored)))
        return path;
    const fs::path resolved = fs::canonical(path, ignored);
    return ignored ? path : resolved;
}

bool isDeviceOrPipe(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() { (void)close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
    [[nodiscard]] int get() const { return fd_; }
    /// False if the system reports on closing that the bytes were not written.
    [[nodiscard]] bool close() {
        const int fd = fd_;
        fd_ = -1;
        return fd < 0 || platform::closeFile(fd);
    }

private:
    int fd_;
};

/// The beginning of a file name: systems limit its length. No character is cut in two.
std::string shortened(std::string name) {
    constexpr std::size_t kMost = 200; // bytes
    if (name.size() > kMost) {
        std::size_t end = kMost;
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u)
            --end;
        name.resize(end);
    }
    return name;
}

/// A new file beside `path`. The destructor removes it unless it was moved into place.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& path)
        : name_(path.parent_path() /
                fmt::format(".{}.{}.tmp", shortened(path.filename().string()), platform::processId())),
          file_(platform::createFile(name_)), present_(file_.isOpen()) {}
    ~TemporaryFile() {
        if (!present_)
            return;
        (void)file_.close(); // Windows removes no open file
        std::error_code ignored;
        fs::remove(name_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] bool made() const { return present_; }
    [[nodiscard]] Descriptor& file() { return file_; }
    [[nodiscard]] bool moveTo(const fs::path& path) {
        present_ = !platform::replaceFile(name_, path);
        return !present_;
    }

private:
    fs::path name_;
    Descriptor file_;
    bool present_;
};

bool writeAll(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::ptrdiff_t written = platform::writeSome(fd, bytes);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

Result<PictureFormat> formatFor(const fs::path& path) {
    if (!path.empty() && isDeviceOrPipe(target(path)))
        return PictureFormat::Png;
    return pictureFormatOf(path);
}

} // namespace

Result<void> checkWritable(const fs::path& path) {
    if (path.empty())
        return refused(path, "the name of an output file is empty; give a file name");
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        return refused(path, "is a directory, not a file to write; add a file name");
    const fs::path place = target(path);
    if (fs::exists(place, ignored) && !platform::isWritable(place))
        return refused(path, notWritten(errno));
    if (isDeviceOrPipe(place))
        return {};
    const UninterruptedWrite whole;
    if (const TemporaryFile probe(place); !probe.made())
        return refused(path, notWritten(errno));
    return {};
}

Result<void> writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    const fs::path place = target(path);
    if (isDeviceOrPipe(place)) {
        Descriptor device(platform::openDevice(place));
        if (!device.isOpen() || !writeAll(device.get(), bytes) || !device.close())
            return refused(path, notWritten(errno));
        return {};
    }
    const UninterruptedWrite whole; // destroyed after the temporary file
    TemporaryFile temporary(place);
    if (!temporary.made() || !writeAll(temporary.file().get(), bytes) || !temporary.file().close() ||
        !temporary.moveTo(place))
        return refused(path, notWritten(errno));
    return {};
}

Result<void> writeFile(const fs::path& path, std::string_view text) {
    return writeFile(path, std::as_bytes(std::span(text)));
}

Result<void> checkPictureWritable(const fs::path& path) {
    const Result<PictureFormat> format = formatFor(path);
    return format ? checkWritable(path) : Failure(format.error());
}

Result<void> writePicture(const fs::path& path, const Picture& picture) {
    const Result<PictureFormat> format = formatFor(path);
    if (!format)
        return Failure(format.error());
    const Result<std::vector<std::byte>> bytes = encodePicture(picture, *format);
    if (!bytes)
        return Failure(bytes.error());
    return writeFile(path, *bytes);
}

Result<void> makeDirectory(const fs::path& path) {
    std::error_code error, ignored;
    fs::create_directories(path, error);
    if (!fs::is_directory(path, ignored))
        return refused(path, fmt::format("the directory cannot be made: {}; choose another one",
                                         error ? error.message() : "a file has that name"));
    return {};
}

Result<std::string> readTextFile(const fs::path& path, std::size_t limit) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return refused(path, "is a directory, not a file to read; add a file name");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(platform::openFile(path, "rb"), &std::fclose);
    if (!file)
        return refused(path,
                       fmt::format("cannot be read: {}; check its name and permissions", reason(errno)));
    std::string text;
    char chunk[4096];
    std::size_t got = 0;
    while ((got = std::fread(chunk, 1, sizeof chunk, file.get())) > 0) {
        text.append(chunk, got);
        if (text.size() > limit)
            return refused(path,
                           fmt::format("is longer than {} bytes, the limit for this kind of file", limit));
    }
    if (std::ferror(file.get()) != 0)
        return refused(path,
                       fmt::format("cannot be read: {}; check its name and permissions", reason(errno)));
    return text;
}

} // namespace limen::output
