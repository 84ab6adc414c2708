#pragma once

namespace limen::platform {

/// From now on a fault of this process (memory, instruction, arithmetic) writes to stderr the thread and, innermost call first, the
/// library and the offset of each call. Then the process ends as without this. `program`: its name, which must stay valid.
/// On POSIX systems the fault may be an exhausted stack of the calling thread. That of another thread ends the process without a
/// report.
/// A fault that something else handles already, as a sanitizer does, is left to it.
void reportCrashes(const char* program);

} // namespace limen::platform
