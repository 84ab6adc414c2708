#include "cli/Verbs.h"
#include "cli/help/CommandFacts.h"
#include "cli/help/ParseFailure.h"
#include "core/platform/Environment.h"
#include "core/platform/Files.h"
#include "engine/HeapTuning.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <system_error>

namespace limen::cli {
namespace {

/// Prints --help and --version as data, and any parse error as one line.
Exit reportParse(const CLI::App& program, const CLI::ParseError& error, const Console& console) {
    if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr) {
        std::vector<std::string> path;
        for (const CLI::App* app = &chosenCommand(program); app != nullptr; app = app->get_parent())
            path.insert(path.begin(), app->get_name());
        console.data(helpPage(factsOf(chosenCommand(program), path)));
        return Exit::Done;
    }
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        console.data(fmt::format("{}\n", error.what()));
        return Exit::Done;
    }
    console.error(parseFailure(program, error));
    return Exit::Impossible;
}

Exit runChoice(const Choice& choice, const Console& console) {
    if (choice.runsForHours)
        engine::tuneHeapForHours();
    else
        engine::tuneHeapForOneRun();
    const Result<Exit> done = choice.run();
    if (!done) {
        console.error(done.error());
        return Exit::Impossible;
    }
    return *done;
}

void addVerbs(CLI::App& program, const Console& console, Choice& choice) {
    addViewVerb(program, console, choice);
    addShotVerb(program, console, choice);
    addTourVerb(program, console, choice);
    addWalkVerb(program, console, choice);
    addProbeVerb(program, console, choice);
    addCheckVerb(program, console, choice);
    addPlacesVerb(program, console, choice);
    addDoctorVerb(program, console, choice);
    addMapVerb(program, console, choice);
    addDatVerb(program, console, choice);
    addWorldVerb(program, console, choice);
    addDemoVerb(program, console, choice);
    addBenchVerb(program, console, choice);
    addHelpVerb(program, console, choice);
    addManVerb(program, console, choice);
    addCompletionsVerb(program, console, choice);
}

Exit parseAndRun(CLI::App& program, int argc, const char* const* argv, const Choice& choice,
                 const Console& console) {
    try {
        program.parse(argc, argv);
        if (!choice.run && platform::hasDesktop())
            program.parse("view");
        if (choice.run)
            return runChoice(choice, console);
        console.data(helpPage(factsOf(program, {program.get_name()})));
        return Exit::Done;
    } catch (const CLI::ParseError& error) {
        return reportParse(program, error, console);
    } catch (const std::bad_alloc&) {
        console.error({ErrorCode::Unsupported, "", "out of memory; choose a smaller --size or --radius"});
    } catch (const std::filesystem::filesystem_error& error) {
        const bool isNoText = error.code() == std::errc::illegal_byte_sequence;
        console.error({ErrorCode::Unsupported, "", isNoText ? platform::kNoText : error.what()});
    } catch (const std::exception& error) {
        console.error({ErrorCode::Unsupported, "unexpected", error.what()});
    }
    return Exit::Impossible;
}

} // namespace

Exit runProgram(int argc, const char* const* argv, const Console& console) {
    Choice choice;
    CLI::App program("draw worlds of interiors and landscape joined by portals", "limen");
    program.set_help_flag("-h,--help", "print this help");
    program.set_version_flag("--version", std::string("limen ") + LIMEN_VERSION, "print the version");
    program.require_subcommand(0, 1);
    program.footer(
        "Without a verb the window opens; without a display this help is printed. Without --dat every verb\n"
        "uses the built-in world. To read about one verb: limen help VERB.\n"
        "Exit codes: 0: done; 1: a finding (a missed target, a wrong pixel); 2: an error; 130, 143: ended\n"
        "by Ctrl-C or SIGTERM.\n"
        "Examples:\n"
        "  limen shot --at hill -o hill.png\n"
        "  limen help shot");
    addVerbs(program, console, choice);
    Exit exit = parseAndRun(program, argc, argv, choice, console);
    if (!console.flush() && exit != Exit::Impossible) {
        console.error({ErrorCode::Unreadable, "standard output",
                       "lost a part of the result; check the disk or the pipe"});
        exit = Exit::Impossible;
    }
    return exit;
}

} // namespace limen::cli
