#include "core/platform/CrashReport.h"

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace limen::platform {
namespace {

void prepare() {
    for (const int handled : {SIGSEGV, SIGFPE})
        std::signal(handled, SIG_DFL);
    reportCrashes("a-program");
}

void crash(int signal) {
    prepare();
    std::raise(signal);
}

TEST(CrashReportDeathTest, namesTheSignalTheThreadAndTheCallsAndEndsByTheSignal) {
    EXPECT_EXIT(crash(SIGSEGV), ::testing::KilledBySignal(SIGSEGV),
                "a-program: crashed by signal 11 at address .* in thread .*; please report these lines\n"
                "  /.*\\+0x[0-9a-f]+\n"
                "a-program: calls\n"
                "(.*\n)*  /.*core_tests\\+0x[0-9a-f]+\n");
    EXPECT_EXIT(crash(SIGFPE), ::testing::KilledBySignal(SIGFPE), "a-program: crashed by signal 8");
}

TEST(CrashReportDeathTest, reportsOneOfSeveralThreadsThatCrashTogether) {
    const auto crashTwice = [] {
        prepare();
        std::thread other([] { std::raise(SIGSEGV); });
        std::raise(SIGSEGV);
        other.join();
    };
    const std::string once = "a-program: crashed by";
    EXPECT_EXIT(crashTwice(), ::testing::KilledBySignal(SIGSEGV),
                ::testing::Truly([&](const std::string& text) {
                    return text.find(once) != std::string::npos && text.find(once) == text.rfind(once);
                }));
}

int recurse(int depth) {
    const volatile char room[4096]{};
    return depth < 0 ? 0 : recurse(depth + 1) + room[0];
}

TEST(CrashReportDeathTest, reportsAnExhaustedStackOfTheThreadThatAskedForReports) {
    const auto exhaust = [] {
        prepare();
        ::_exit(recurse(0));
    };
    EXPECT_EXIT(exhaust(), ::testing::KilledBySignal(SIGSEGV),
                "a-program: crashed by signal 11 at address .*\n"
                "  /.*core_tests\\+0x[0-9a-f]+\n");
}

TEST(CrashReportDeathTest, leavesAFaultToTheHandlerThatIsThere) {
    const auto crashHandled = [] {
        std::signal(SIGSEGV, [](int) { ::_exit(9); });
        reportCrashes("a-program");
        std::raise(SIGSEGV);
    };
    EXPECT_EXIT(crashHandled(), ::testing::ExitedWithCode(9),
                ::testing::Not(::testing::HasSubstr("crashed")));
}

} // namespace
} // namespace limen::platform
