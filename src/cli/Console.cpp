#include "cli/Console.h"

#include "core/AbsolutePath.h"
#include "core/platform/Terminal.h"

#include <fmt/format.h>

namespace limen::cli {
namespace {

void write(std::FILE* file, std::string_view text) {
    // A failure sets ferror, which flush() checks at the end.
    (void)std::fwrite(text.data(), 1, text.size(), file);
}

/// Writes at once: on Windows no stream is written line by line.
void writeNow(std::FILE* file, std::string_view text) {
    write(file, text);
    (void)std::fflush(file);
}

} // namespace

Console::Console(std::FILE* out, std::FILE* err, Interrupt interrupt)
    : out_(out), err_(err), interrupt_(interrupt), isOutTerminal_(platform::isTerminal(out)) {}

void Console::data(std::string_view text) const {
    if (isOutTerminal_)
        writeNow(out_, text);
    else
        write(out_, text);
}

void Console::note(std::string_view text) const {
    writeNow(err_, fmt::format("{}\n", text));
}

void Console::wrote(const std::filesystem::path& path, std::string_view content) const {
    const std::filesystem::path full = absolutePath(path).lexically_normal();
    note(fmt::format("Wrote {}{}{}", full.string(), content.empty() ? "" : ": ", content));
}

void Console::error(const Error& error) const {
    std::string line = fmt::format("limen: {}", error.message());
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            c = ' ';
    note(line);
}

bool Console::flush() const {
    return std::fflush(out_) == 0 && std::ferror(out_) == 0;
}

bool Console::isTerminal() const {
    return platform::isTerminal(err_);
}

Progress::Progress(const Console& console, std::string_view title, std::size_t total)
    : console_(console), title_(title), total_(total) {}

Progress::~Progress() {
    if (shown_)
        writeNow(console_.err(), "\r\x1b[K"); // erase the bar
}

void Progress::step(std::size_t done) {
    const Clock::time_point now = Clock::now();
    const bool due = now - start_ > std::chrono::seconds(1) && now - drawn_ > std::chrono::milliseconds(100);
    if (!due || total_ == 0 || !console_.isTerminal())
        return;
    constexpr std::size_t kWidth = 30;
    const std::size_t filled = kWidth * std::min(done, total_) / total_;
    writeNow(console_.err(), fmt::format("\r\x1b[K{} [{:#<{}}{:.<{}}] {}/{}", title_, "", filled, "",
                                         kWidth - filled, done, total_));
    drawn_ = now;
    shown_ = true;
}

Waiting::Waiting(const Console& console, std::string title) : console_(console), title_(std::move(title)) {
    if (console.isTerminal())
        thread_ = std::thread([this] { show(); });
}

Waiting::~Waiting() {
    if (!thread_.joinable())
        return;
    {
        const std::lock_guard guard(lock_);
        isEnding_ = true;
    }
    ended_.notify_one();
    thread_.join();
}

void Waiting::show() {
    std::unique_lock guard(lock_);
    for (int seconds = 1; !ended_.wait_for(guard, std::chrono::seconds(1), [this] { return isEnding_; });
         ++seconds)
        writeNow(console_.err(), fmt::format("\r\x1b[K{} ... {} s", title_, seconds));
    writeNow(console_.err(), "\r\x1b[K");
}

} // namespace limen::cli
