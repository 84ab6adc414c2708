#include "cli/help/ParseFailure.h"

#include "cli/help/CommandFacts.h"
#include "core/Nearest.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace limen::cli {
namespace {

/// "dat ls"; empty for the program itself.
std::string verbPath(const CLI::App& command) {
    std::string path;
    for (const CLI::App* app = &command; app->get_parent() != nullptr; app = app->get_parent())
        path.insert(0, app->get_name() + (path.empty() ? "" : " "));
    return path;
}

std::string readHelp(const CLI::App& command) {
    const std::string verb = verbPath(command);
    return verb.empty() ? "see limen help" : "see limen help " + verb;
}

/// The first argument that CLI11 could not place; empty: none.
std::string strayArgument(const CLI::App& program) {
    const std::vector<std::string> left = program.remaining(true);
    return left.empty() ? std::string() : left.front();
}

std::vector<std::string> verbNames(const CommandFacts& facts) {
    std::vector<std::string> names;
    for (const CommandFacts& verb : facts.commands)
        names.push_back(verb.name());
    return names;
}

std::vector<std::string> longOptions(const CommandFacts& facts) {
    std::vector<std::string> names;
    for (const OptionFacts& option : facts.options)
        for (const std::string& name : option.names)
            if (name.starts_with("--"))
                names.push_back(name);
    return names;
}

/// A sentence with the nearest name, or the help page to read.
std::string hint(const std::string& name, const std::vector<std::string>& names, const CLI::App& command) {
    const std::vector<std::string> similar = nearest(name, names, 1);
    return similar.empty() ? "; " + readHelp(command) : "." + didYouMean(similar);
}

Error strayFailure(const CLI::App& command, const std::string& stray) {
    const CommandFacts facts = factsOf(command, {command.get_name()});
    const std::string verb = verbPath(command);
    const auto failure = [&](std::string what) {
        return Error{ErrorCode::BadArgument, verb, std::move(what)};
    };
    if (stray.starts_with('-')) {
        const std::string name = stray.substr(0, stray.find('='));
        return failure(fmt::format("unknown option '{}'{}", name, hint(name, longOptions(facts), command)));
    }
    if (!facts.commands.empty())
        return failure(fmt::format("unknown verb '{}'{}", stray, hint(stray, verbNames(facts), command)));
    return failure(fmt::format("unexpected argument '{}'; {}", stray, readHelp(command)));
}

} // namespace

const CLI::App& chosenCommand(const CLI::App& program) {
    const CLI::App* command = &program;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().front();
    return *command;
}

Error parseFailure(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = chosenCommand(program);
    const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const std::string stray = strayArgument(program);
    const bool needsVerb = command.get_require_subcommand_min() > 0 && command.get_subcommands().empty();
    if (!stray.empty() && (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr || (lacks && needsVerb)))
        return strayFailure(command, stray);
    const std::string verb = verbPath(command);
    if (lacks && needsVerb)
        return {ErrorCode::BadArgument, verb, "no verb given; choose one from limen help " + verb};
    if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr)
        return {ErrorCode::BadArgument, verb, error.what()}; // its messages name the next step
    std::string what = error.what();
    while (!what.empty() && (what.back() == '\n' || what.back() == '.'))
        what.pop_back();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) // "--eye: 1 required X,Y,Z missing"
        what = what.substr(0, what.find(": ")) + ": the value is missing, or there are too many";
    return {ErrorCode::BadArgument, verb, what + "; " + readHelp(command)};
}

} // namespace limen::cli
