#include "cli/Verbs.h"
#include "core/platform/CrashReport.h"

int main(int argc, char** argv) {
    limen::platform::reportCrashes("limen");
    const limen::cli::Console console(stdout, stderr, limen::Interrupt::install());
    const limen::cli::Exit exit = limen::cli::runProgram(argc, argv, console);
    if (exit == limen::cli::Exit::Interrupted && console.interrupt().isRequested())
        console.interrupt().die();
    return static_cast<int>(exit);
}
