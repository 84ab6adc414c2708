#pragma once

#include "core/Error.h"

#include <sys/wait.h>
#include <unistd.h>

namespace limen::bench {

/// Does something in a process of its own, so that the memory it takes is none of this one's; waits for it. Requires that no other thread
/// holds a lock. Errors: it fails, without saying why; no process can be made.
template <class Work>
[[nodiscard]] Result<void> inChildProcess(Work&& work) {
    const ::pid_t child = ::fork();
    if (child == 0)
        ::_exit(work() ? 0 : 1); // destructors are the parent's
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return fail(ErrorCode::Unreadable, "bench", "what the benchmark runs on could not be made");
    return {};
}

} // namespace limen::bench
