#include "cli/Choices.h"
#include "cli/Verbs.h"
#include "cli/help/Completions.h"
#include "cli/help/ManPage.h"
#include "engine/WorldSource.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace limen::cli {
namespace {

/// The arguments of `help`, `man` and `completions`.
struct HelpArguments {
    std::vector<std::string> names;
    std::string output, shell;
};

Result<const CommandFacts*> namedCommand(const CommandFacts& root, const std::vector<std::string>& names) {
    const CommandFacts* command = &root;
    for (const std::string& name : names) {
        const CommandFacts* below = commandAt(*command, {name});
        if (below == nullptr) {
            std::vector<std::string> known;
            for (const CommandFacts& verb : command->commands)
                known.push_back(verb.name());
            if (known.empty())
                return fail(ErrorCode::NotFound, command->joined(),
                            fmt::format("has no verbs of its own; leave '{}' out", name));
            return fail(ErrorCode::NotFound, "",
                        fmt::format("unknown verb '{}'{}", name, suggestion(name, known)));
        }
        command = below;
    }
    return command;
}

/// Writes the pages of a command and of all verbs below it. Returns their number.
Result<std::size_t> writePages(const CommandFacts& command, const CommandFacts& root,
                               const std::filesystem::path& directory) {
    std::size_t count = 1;
    if (Result<void> written = output::writeFile(directory / (command.joined('-') + ".1"),
                                                 manPage(command, root, LIMEN_VERSION));
        !written)
        return Failure(written.error());
    for (const CommandFacts& below : command.commands) {
        Result<std::size_t> more = writePages(below, root, directory);
        if (!more)
            return more;
        count += *more;
    }
    return count;
}

Result<Exit> runMan(const CLI::App& program, const HelpArguments& arguments, const Console& console) {
    const CommandFacts root = factsOf(program, {program.get_name()});
    const Result<const CommandFacts*> command = namedCommand(root, arguments.names);
    if (!command)
        return Failure(command.error());
    if (arguments.output.empty()) {
        console.data(manPage(**command, root, LIMEN_VERSION));
        return Exit::Done;
    }
    if (Result<void> made = output::makeDirectory(arguments.output); !made)
        return Failure(made.error());
    const Result<std::size_t> count = writePages(**command, root, arguments.output);
    if (!count)
        return Failure(count.error());
    console.wrote(arguments.output, fmt::format("{} manual pages", *count));
    return Exit::Done;
}

/// The places of the built-in world; none if it cannot be opened.
std::vector<std::string> builtInPlaces() {
    std::vector<std::string> names;
    if (const Result<engine::WorldSource> source = engine::openWorldSource(""))
        for (const world::Place& place : source->file.places)
            names.push_back(place.name);
    return names;
}

Result<Exit> runCompletions(const CLI::App& program, const HelpArguments& arguments, const Console& console) {
    const CommandFacts root = factsOf(program, {program.get_name()});
    const std::vector<std::string> places = builtInPlaces();
    const std::string text =
        arguments.shell == "bash" ? bashCompletions(root, places) : zshCompletions(root, places);
    if (arguments.output.empty()) {
        console.data(text);
        return Exit::Done;
    }
    if (Result<void> written = output::writeFile(arguments.output, text); !written)
        return Failure(written.error());
    console.wrote(arguments.output, fmt::format("completions for {}", arguments.shell));
    return Exit::Done;
}

} // namespace

void addHelpVerb(CLI::App& program, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<HelpArguments>();
    CLI::App* verb = program.add_subcommand("help", "explain a verb and its options");
    verb->add_option("VERB", arguments->names, "explain this verb, e.g. shot, or dat ls (list all verbs)")
        ->type_name("");
    verb->footer("Examples:\n  limen help\n  limen help dat ls");
    verb->callback([&program, &console, &choice, arguments] {
        choice.run = [&program, &console, arguments]() -> Result<Exit> {
            const CommandFacts root = factsOf(program, {program.get_name()});
            const Result<const CommandFacts*> command = namedCommand(root, arguments->names);
            if (!command)
                return Failure(command.error());
            console.data(helpPage(**command));
            return Exit::Done;
        };
    });
}

void addManVerb(CLI::App& program, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<HelpArguments>();
    CLI::App* verb = program.add_subcommand("man", "print a manual page for man(1)");
    verb->add_option("VERB", arguments->names, "print the page of this verb (the page of the program)")
        ->type_name("");
    verb->add_option("-o,--output", arguments->output,
                     "write this page and those of the verbs below it to this directory (standard output)")
        ->type_name("DIR")
        ->check(notEmpty());
    verb->footer("Read a page with man -l FILE.\nExamples:\n  limen man shot\n  limen man -o man");
    verb->callback([&program, &console, &choice, arguments] {
        choice.run = [&program, &console, arguments] { return runMan(program, *arguments, console); };
    });
}

void addCompletionsVerb(CLI::App& program, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<HelpArguments>();
    CLI::App* verb = program.add_subcommand("completions", "print completions for a shell");
    verb->add_option("SHELL", arguments->shell, "choose the shell: bash or zsh")
        ->required()
        ->type_name("bash|zsh")
        ->check(oneOf({"bash", "zsh"}));
    verb->add_option("-o,--output", arguments->output, "write to this file (standard output)")
        ->type_name("FILE")
        ->check(notEmpty());
    verb->footer(
        "bash: put the file limen into ~/.local/share/bash-completion/completions. zsh: put the file\n"
        "_limen into a directory of fpath.\n"
        "Examples:\n  limen completions bash -o limen\n  limen completions zsh -o _limen");
    verb->callback([&program, &console, &choice, arguments] {
        choice.run = [&program, &console, arguments] { return runCompletions(program, *arguments, console); };
    });
}

} // namespace limen::cli
