#include "core/platform/CrashReport.h"

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace limen::platform {
namespace {

void crash(int signal) {
    for (const int handled : {SIGSEGV, SIGFPE})
        std::signal(handled, SIG_DFL);
    reportCrashes("a-program");
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
