#include "cli/Verbs.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/format.h>
#include <new>

namespace limen::cli {
namespace {

/// Prints --help and --version as data, and any parse error as one line.
Exit reportParse(const CLI::App& program, const CLI::ParseError& error, const Console& console) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr ||
            dynamic_cast<const CLI::CallForAllHelp*>(&error) != nullptr)
            console.data(program.help());
        else
            console.data(fmt::format("{}\n", error.what()));
        return Exit::Done;
    }
    const bool noVerb =
        dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && program.get_subcommands().empty();
    console.error(
        {ErrorCode::BadArgument, "", noVerb ? "no verb given; choose one from limen --help" : error.what()});
    return Exit::Impossible;
}

Exit runChoice(const Choice& choice, const Console& console) {
    const Result<Exit> done = choice.run();
    if (!done) {
        console.error(done.error());
        return Exit::Impossible;
    }
    return *done;
}

} // namespace

Exit runProgram(int argc, const char* const* argv, const Console& console) {
    Choice choice;
    CLI::App program("Limen draws worlds of interiors and landscape joined by portals.\n"
                     "Without --dat every verb uses the built-in world.",
                     "limen");
    program.set_version_flag("--version", std::string("limen ") + LIMEN_VERSION);
    program.require_subcommand(1);
    program.footer("To see the options of a verb, run limen VERB --help.\n"
                   "Example: limen shot --at hill -o hill.png\n"
                   "Exit codes: 0: done; 1: a finding (a missed target, a wrong pixel); 2: an error.");
    addViewVerb(program, console, choice);
    addShotVerb(program, console, choice);
    addTourVerb(program, console, choice);
    addProbeVerb(program, console, choice);
    addWalkVerb(program, console, choice);
    addCheckVerb(program, console, choice);
    addMapVerb(program, console, choice);
    addDatVerb(program, console, choice);
    addDemoVerb(program, console, choice);
    addBenchVerb(program, console, choice);
    Exit exit = Exit::Impossible;
    try {
        program.parse(argc, argv);
        exit = runChoice(choice, console);
    } catch (const CLI::ParseError& error) {
        exit = reportParse(program, error, console);
    } catch (const std::bad_alloc&) {
        console.error({ErrorCode::Unsupported, "", "out of memory; choose a smaller --size or --radius"});
    } catch (const std::exception& error) {
        console.error({ErrorCode::Unsupported, "unexpected", error.what()});
    }
    if (!console.flush() && exit != Exit::Impossible) {
        console.error({ErrorCode::Unreadable, "standard output",
                       "lost a part of the result; check the disk or the pipe"});
        exit = Exit::Impossible;
    }
    return exit;
}

} // namespace limen::cli
