#include "core/Interrupt.h"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limen {
namespace {

/// Runs `body` in a child process and returns the status of `waitpid`. The child exits with 7 after `body`.
template <class Body>
int statusOf(Body&& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        body(Interrupt::install());
        ::_exit(7);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

bool endedBy(int status, int signal) {
    return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

bool finished(int status) {
    return WIFEXITED(status) && WEXITSTATUS(status) == 7;
}

TEST(Interrupt, endsAtOnceUnlessTheVerbDefersIt) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_TRUE(endedBy(statusOf([&](const Interrupt&) { ::raise(signal); }), signal)) << signal;
}

TEST(Interrupt, onlySetsTheSignalOnceDeferred) {
    const int status = statusOf([](const Interrupt& interrupt) {
        interrupt.defer();
        ::raise(SIGTERM);
        if (!interrupt.isRequested() || interrupt.signal() != SIGTERM)
            ::_exit(1);
    });
    EXPECT_TRUE(finished(status)) << status;
}

TEST(Interrupt, aSecondSignalEndsAtOnce) {
    const int status = statusOf([](const Interrupt& interrupt) {
        interrupt.defer();
        ::raise(SIGINT);
        ::raise(SIGINT);
    });
    EXPECT_TRUE(endedBy(status, SIGINT)) << status;
}

TEST(Interrupt, aWriteIsFinishedFirst) {
    const int whole = statusOf([](const Interrupt&) {
        const UninterruptedWrite write;
        ::raise(SIGTERM);
        ::raise(SIGTERM);
        ::_exit(7); // the signals wait for the end of the write
    });
    EXPECT_TRUE(finished(whole)) << whole;
    const int after = statusOf([](const Interrupt&) {
        {
            const UninterruptedWrite write;
            ::raise(SIGTERM);
        }
        ::_exit(1);
    });
    EXPECT_TRUE(endedBy(after, SIGTERM)) << after;
}

TEST(Interrupt, aWriteOfADeferringVerbDoesNotEndIt) {
    const int status = statusOf([](const Interrupt& interrupt) {
        interrupt.defer();
        const UninterruptedWrite write;
        ::raise(SIGINT);
    });
    EXPECT_TRUE(finished(status)) << status;
}

TEST(Interrupt, diesByTheFirstSignal) {
    const int status = statusOf([](const Interrupt& interrupt) {
        interrupt.defer();
        ::raise(SIGHUP);
        interrupt.die();
    });
    EXPECT_TRUE(endedBy(status, SIGHUP)) << status;
}

TEST(Interrupt, signalsIgnoredFromTheStartStayIgnored) {
    const int status = statusOf([](const Interrupt&) {
        std::signal(SIGHUP, SIG_IGN); // as nohup does before the program starts
        (void)Interrupt::install();
        ::raise(SIGHUP);
    });
    EXPECT_TRUE(finished(status)) << status;
}

TEST(Interrupt, oneThatIsNotInstalledIsNeverRequested) {
    EXPECT_EQ(Interrupt().signal(), 0);
}

} // namespace
} // namespace limen
