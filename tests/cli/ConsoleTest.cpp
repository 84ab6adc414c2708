#include "cli/Console.h"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace limen::cli {
namespace {

/// A pseudo-terminal, whose other end keeps everything that is written to it.
class Terminal {
public:
    Terminal() : other_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        std::array<char, 64> name{};
        if (other_ < 0 || ::grantpt(other_) != 0 || ::unlockpt(other_) != 0 ||
            ::ptsname_r(other_, name.data(), name.size()) != 0)
            return;
        file_ = std::fopen(name.data(), "w");
    }
    ~Terminal() {
        if (file_ != nullptr)
            (void)std::fclose(file_);
        ::close(other_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    [[nodiscard]] std::FILE* file() const { return file_; }
    /// Everything written since the last call.
    [[nodiscard]] std::string read() const {
        (void)std::fflush(file_);
        std::string text;
        std::array<char, 256> part{};
        for (pollfd waiting{other_, POLLIN, 0}; ::poll(&waiting, 1, 50) == 1;)
            if (const ssize_t size = ::read(other_, part.data(), part.size()); size > 0)
                text.append(part.data(), static_cast<std::size_t>(size));
        return text;
    }

private:
    int other_;
    std::FILE* file_ = nullptr;
};

constexpr std::chrono::milliseconds kUntilShown{1050}; // bars appear after a second

TEST(ProgressBar, appearsAfterASecond_andIsErased) {
    const Terminal terminal;
    ASSERT_NE(terminal.file(), nullptr);
    const Console console(stdout, terminal.file());
    ASSERT_TRUE(console.isTerminal());
    {
        Progress bar(console, "reading", 4);
        bar.step(1);
        EXPECT_EQ(terminal.read(), "") << "short work has no bar";
        std::this_thread::sleep_for(kUntilShown);
        bar.step(2);
        const std::string shown = terminal.read();
        EXPECT_NE(shown.find("reading [###############...............] 2/4"), std::string::npos) << shown;
        EXPECT_EQ(shown.find('\n'), std::string::npos) << "one line";
    }
    EXPECT_EQ(terminal.read(), "\r\x1b[K");
}

TEST(ProgressBar, staysAwayFromFiles) {
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    {
        const Console console(stdout, file);
        Progress bar(console, "reading", 4);
        const Waiting waiting(console, "searching");
        std::this_thread::sleep_for(kUntilShown);
        bar.step(2);
    }
    EXPECT_EQ(std::ftell(file), 0);
    (void)std::fclose(file);
}

TEST(WaitingLine, countsSeconds_andIsErased) {
    const Terminal terminal;
    ASSERT_NE(terminal.file(), nullptr);
    {
        const Console console(stdout, terminal.file());
        const Waiting waiting(console, "searching");
        std::string shown;
        for (int tries = 0; tries < 100 && shown.find("searching ... 1 s") == std::string::npos; ++tries) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            shown += terminal.read();
        }
        EXPECT_NE(shown.find("searching ... 1 s"), std::string::npos) << shown;
    }
    EXPECT_TRUE(terminal.read().ends_with("\r\x1b[K"));
}

} // namespace
} // namespace limen::cli
