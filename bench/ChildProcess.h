#pragma once

#include "core/Error.h"

#include <sys/wait.h>
#include <unistd.h>

namespace limen::bench {

/// Runs `work` in a child process and waits for it, so that its memory does not count as this process's.
/// Requires that no other thread holds a lock. Errors: the work fails (the reason is lost); no process can be
/// made.
template <class Work>
[[nodiscard]] Result<void> inChildProcess(Work&& work) {
    const ::pid_t child = ::fork();
    if (child == 0)
        ::_exit(work() ? 0 : 1); // _exit: destructors run in the parent only
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return fail(ErrorCode::Unreadable, "bench",
                    "the benchmark's data could not be written; is the temporary directory full?");
    return {};
}

} // namespace limen::bench
