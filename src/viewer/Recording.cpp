#include "viewer/Recording.h"

#include "core/AbsolutePath.h"
#include "core/platform/Files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <span>

namespace limen::viewer {
namespace {

std::size_t countLines(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

Recording::~Recording() {
    if (descriptor_ >= 0)
        (void)platform::closeFile(descriptor_);
}

Result<void> Recording::open(const std::filesystem::path& file) {
    file_ = absolutePath(file);
    descriptor_ = platform::createFile(file);
    if (descriptor_ < 0)
        return fail(ErrorCode::Unreadable, file_.string(),
                    fmt::format("cannot be written: {}", std::strerror(errno)));
    return {};
}

Result<void> Recording::add(const std::string& lines) {
    waiting_ += lines;
    lines_ += countLines(lines);
    return waiting_.size() >= tried_ + kFlushBytes ? flush() : Result<void>{};
}

Result<void> Recording::flush() {
    std::size_t written = 0;
    while (written < waiting_.size()) {
        const std::ptrdiff_t count =
            platform::writeSome(descriptor_, std::as_bytes(std::span(waiting_).subspan(written)));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        written += static_cast<std::size_t>(count);
    }
    const int reason = errno;
    const bool isComplete = written == waiting_.size();
    // Keep whole lines only: a line that is cut off would make the file unreadable.
    const std::size_t last = written > 0 ? waiting_.rfind('\n', written - 1) : std::string::npos;
    const std::size_t whole = isComplete ? written : last == std::string::npos ? 0 : last + 1;
    saved_ += countLines(std::string_view(waiting_).substr(0, whole));
    length_ += static_cast<std::int64_t>(whole);
    waiting_.erase(0, whole);
    tried_ = waiting_.size();
    if (isComplete)
        return {};
    (void)platform::cutFile(descriptor_, length_); // fails on devices, which keep nothing
    return fail(ErrorCode::Unreadable, file_.string(),
                fmt::format("cannot be written: {}; {} of {} lines are saved", std::strerror(reason), saved_,
                            lines_));
}

Result<void> Recording::close() {
    if (descriptor_ < 0)
        return {};
    Result<void> flushed = flush();
    (void)platform::closeFile(descriptor_);
    descriptor_ = -1;
    return flushed;
}

} // namespace limen::viewer
