#include "cli/help/CommandFacts.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::cli {
namespace {

bool isFixedValue(std::string_view word) {
    const bool isNumber = word.find_first_not_of("0123456789") == std::string_view::npos;
    const bool isName = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
    return !word.empty() && (isNumber || isName);
}

/// The fixed values of a notation such as "auto|outside|0xCELL": auto and outside.
std::vector<std::string> choicesOf(const std::string& notation) {
    std::vector<std::string> words;
    if (notation.find('|') == std::string::npos)
        return words;
    for (const std::string& word : CLI::detail::split(notation, '|'))
        if (isFixedValue(word))
            words.push_back(word);
    return words;
}

OptionFacts factsOfOption(const CLI::Option& option) {
    OptionFacts facts;
    facts.isPositional = option.get_positional();
    facts.isRequired = option.get_required();
    const bool takesValue = option.get_items_expected_max() > 0;
    facts.isRepeatable = option.get_items_expected_max() > 1 ||
                         option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (facts.isPositional) {
        facts.names.push_back(option.get_name(true, false));
    } else {
        for (const std::string& name : option.get_snames())
            facts.names.push_back("-" + name);
        for (const std::string& name : option.get_lnames())
            facts.names.push_back("--" + name);
    }
    facts.value = takesValue && !facts.isPositional ? option.get_type_name() : "";
    facts.choices = choicesOf(option.get_type_name());
    facts.help = option.get_description();
    facts.group = facts.isPositional ? "Arguments" : option.get_group();
    return facts;
}

/// Breaks text into lines of at most `width` columns; the lines after the first begin with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::string result;
    std::size_t column = indent;
    for (const std::string& word : CLI::detail::split(text, ' ')) {
        const bool isFirst = result.empty();
        if (!isFirst && column + 1 + word.size() > width) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!isFirst) {
            result += " ";
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result;
}

constexpr std::size_t kHelpColumn = 26;

std::string rowOf(const std::string& left, const std::string& right, std::size_t width) {
    std::string row = "  " + left;
    const bool fits = row.size() + 2 <= kHelpColumn;
    row += fits ? std::string(kHelpColumn - row.size(), ' ') : "\n" + std::string(kHelpColumn, ' ');
    return row + wrapped(right, kHelpColumn, width) + "\n";
}

std::string usageOf(const CommandFacts& command) {
    std::string usage = "Usage: " + command.joined();
    for (const OptionFacts& option : command.options)
        if (!option.isPositional && option.isRequired)
            usage += fmt::format(" {} {}", option.names.front(), option.value);
    usage += " [OPTIONS]";
    for (const OptionFacts& option : command.options) {
        if (!option.isPositional)
            continue;
        const std::string name = option.names.front() + (option.isRepeatable ? "..." : "");
        usage += option.isRequired ? " " + name : " [" + name + "]";
    }
    return usage + (command.commands.empty() ? "" : " VERB");
}

} // namespace

std::string CommandFacts::joined(char separator) const {
    return fmt::format("{}", fmt::join(path, std::string(1, separator)));
}

CommandFacts factsOf(const CLI::App& app, std::vector<std::string> path) {
    CommandFacts facts{std::move(path), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) // hidden options have no group
            facts.options.push_back(factsOfOption(*option));
    std::stable_partition(facts.options.begin(), facts.options.end(),
                          [](const OptionFacts& option) { return option.names.back() != "--help"; });
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        std::vector<std::string> below = facts.path;
        below.push_back(verb->get_name());
        facts.commands.push_back(factsOf(*verb, std::move(below)));
    }
    return facts;
}

const CommandFacts* commandAt(const CommandFacts& root, const std::vector<std::string>& names) {
    const CommandFacts* command = &root;
    for (const std::string& name : names) {
        const auto found = std::find_if(command->commands.begin(), command->commands.end(),
                                        [&](const CommandFacts& below) { return below.name() == name; });
        if (found == command->commands.end())
            return nullptr;
        command = &*found;
    }
    return command;
}

std::vector<NotesPart> partsOf(const std::string& notes) {
    std::vector<NotesPart> parts;
    for (const std::string& line : CLI::detail::split(notes, '\n')) {
        const bool isVerbatim = line.starts_with(' ');
        if (line.empty())
            continue;
        const bool isHeading = line == "Examples:" || line.starts_with("Exit codes:");
        if (parts.empty() || parts.back().isVerbatim != isVerbatim || isHeading)
            parts.push_back({isVerbatim, line});
        else
            parts.back().text += (isVerbatim ? "\n" : " ") + line;
    }
    return parts;
}

std::string helpPage(const CommandFacts& command, std::size_t width) {
    std::string page = wrapped(fmt::format("{}: {}", command.joined(), command.brief), 0, width) + "\n\n" +
                       wrapped(usageOf(command), 4, width) + "\n";
    if (!command.commands.empty())
        page += "\nVerbs:\n";
    for (const CommandFacts& verb : command.commands)
        page += rowOf(verb.name(), verb.brief, width);
    std::vector<std::string> groups;
    for (const OptionFacts& option : command.options)
        if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
            groups.push_back(option.group);
    for (const std::string& group : groups) {
        page += "\n" + group + ":\n";
        for (const OptionFacts& option : command.options)
            if (option.group == group)
                page += rowOf(fmt::format("{}{}{}", fmt::join(option.names, ", "),
                                          option.value.empty() ? "" : " ", option.value),
                              option.help + (option.isRequired && !option.isPositional ? " (required)" : ""),
                              width);
    }
    for (const NotesPart& part : partsOf(command.notes))
        page += (part.isVerbatim ? "" : "\n") + (part.isVerbatim ? part.text : wrapped(part.text, 0, width)) +
                "\n";
    return page;
}

} // namespace limen::cli
