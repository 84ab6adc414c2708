#include "cli/Verbs.h"

int main(int argc, char** argv) {
    const limen::cli::Console console;
    return static_cast<int>(limen::cli::runProgram(argc, argv, console));
}
