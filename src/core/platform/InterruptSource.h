#pragma once

namespace limen::platform {

/// Calls `handler` with the number of each signal that ends a program: SIGINT, SIGTERM and SIGHUP. On Windows these are
/// Ctrl-C (2), Ctrl-Break (15) and the closing of the console or the session (1). The handler may run at any point of any
/// thread. Signals that are ignored stay ignored.
void watchInterrupts(void (*handler)(int));
/// Ends the process by the signal's default action, or with the exit code 128 plus its number. Safe in the handler.
[[noreturn]] void endBySignal(int signal);

} // namespace limen::platform
