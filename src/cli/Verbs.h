#pragma once

#include "cli/Console.h"
#include "core/Error.h"

#include <functional>

namespace CLI {
class App;
}

// One function per verb. It declares the verb's options and sets Choice::run if the verb is chosen. Nothing
// runs during parsing.
namespace limen::cli {

/// The chosen verb, ready to run.
struct Choice {
    std::function<Result<Exit>()> run;
    bool runsForHours = false; ///< the others end when they have drawn, traced or written
};

void addDoctorVerb(CLI::App& program, const Console& console, Choice& choice);
void addDemoVerb(CLI::App& program, const Console& console, Choice& choice);
void addShotVerb(CLI::App& program, const Console& console, Choice& choice);
void addCheckVerb(CLI::App& program, const Console& console, Choice& choice);
void addProbeVerb(CLI::App& program, const Console& console, Choice& choice);
void addWalkVerb(CLI::App& program, const Console& console, Choice& choice);
void addTourVerb(CLI::App& program, const Console& console, Choice& choice);
void addPlacesVerb(CLI::App& program, const Console& console, Choice& choice);
void addMapVerb(CLI::App& program, const Console& console, Choice& choice);
void addWorldVerb(CLI::App& program, const Console& console, Choice& choice);
void addDatVerb(CLI::App& program, const Console& console, Choice& choice);
void addViewVerb(CLI::App& program, const Console& console, Choice& choice);
void addBenchVerb(CLI::App& program, const Console& console, Choice& choice);
void addHelpVerb(CLI::App& program, const Console& console, Choice& choice);
void addManVerb(CLI::App& program, const Console& console, Choice& choice);
void addCompletionsVerb(CLI::App& program, const Console& console, Choice& choice);

/// Runs the program: parses the command line, runs the verb, and prints an error as one line on standard
/// error.
[[nodiscard]] Exit runProgram(int argc, const char* const* argv, const Console& console);

} // namespace limen::cli
