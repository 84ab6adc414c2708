#include "app/Verbs.h"

int main(int argc, char** argv) {
    const limen::app::Console console;
    return static_cast<int>(limen::app::runProgram(argc, argv, console));
}
