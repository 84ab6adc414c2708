#pragma once

#include "cli/Console.h"
#include "core/Error.h"

#include <functional>

namespace CLI {
class App;
}

// One function a verb: it declares the verb's options on the command line, and what is to be done when the
// verb was chosen. Nothing runs while the command line is read.
namespace limen::cli {

/// What the command line asks for.
struct Choice {
    std::function<Result<Exit>()> run;
};

void addDemoVerb(CLI::App& program, const Console& console, Choice& choice);
void addShotVerb(CLI::App& program, const Console& console, Choice& choice);
void addCheckVerb(CLI::App& program, const Console& console, Choice& choice);
void addProbeVerb(CLI::App& program, const Console& console, Choice& choice);
void addWalkVerb(CLI::App& program, const Console& console, Choice& choice);
void addTourVerb(CLI::App& program, const Console& console, Choice& choice);
void addDatVerb(CLI::App& program, const Console& console, Choice& choice);
void addViewVerb(CLI::App& program, const Console& console, Choice& choice);
void addBenchVerb(CLI::App& program, const Console& console, Choice& choice);

/// The whole program: reads the command line, does what it says, turns an error into one line on standard
/// error.
[[nodiscard]] Exit runProgram(int argc, const char* const* argv, const Console& console);

} // namespace limen::cli
