#include "cli/help/Completions.h"

#include "cli/help/ValueKind.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace limen::cli {
namespace {

void forEachCommand(const CommandFacts& command, const std::function<void(const CommandFacts&)>& visit) {
    visit(command);
    for (const CommandFacts& below : command.commands)
        forEachCommand(below, visit);
}

/// A text inside of single quotes of a shell, without the quotes.
std::string inQuotes(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result;
}

std::vector<std::string> namesOf(const std::vector<CommandFacts>& commands) {
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const CommandFacts& command : commands)
        names.push_back(command.name());
    return names;
}

/// The bash statement that completes a value of this option; empty: nothing to offer.
std::string bashReply(const OptionFacts& option, const CommandFacts& root,
                      std::span<const std::string> places) {
    const auto words = [](const auto& list) {
        return fmt::format("_limen_words '{}'", inQuotes(fmt::format("{}", fmt::join(list, " "))));
    };
    switch (valueKindOf(option)) {
    case ValueKind::Choice:
        return words(option.choices);
    case ValueKind::Place:
        return words(places);
    case ValueKind::Verb:
        return words(namesOf(root.commands));
    case ValueKind::File:
        return "_limen_files -f";
    case ValueKind::Directory:
        return "_limen_files -d";
    case ValueKind::None:
    case ValueKind::Other:
        break;
    }
    return {};
}

constexpr const char* kBashHead = R"(# bash completion for limen, printed by: limen completions bash
_limen_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}
_limen_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$current")
}
_limen() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} path=limen i
    COMPREPLY=()
    if [[ $previous == = ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    elif [[ $current == = ]]; then
        current=
    fi
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$path ${COMP_WORDS[i]}" in
)";

/// Joins patterns of a `case` line.
std::string patterns(const std::vector<std::string>& texts) {
    std::string joined;
    for (const std::string& text : texts)
        joined += (joined.empty() ? "'" : " | '") + inQuotes(text) + "'";
    return joined;
}

} // namespace

ValueKind valueKindOf(const OptionFacts& option) {
    if (!option.choices.empty())
        return ValueKind::Choice;
    const std::string& word = option.isPositional ? option.names.front() : option.value;
    if (word.empty())
        return ValueKind::None;
    if (word == "PLACE")
        return ValueKind::Place;
    if (word == "VERB")
        return ValueKind::Verb;
    if (word == "DIR")
        return ValueKind::Directory;
    return word == "FILE" || word == "PATH" || word == "INPUT" ? ValueKind::File : ValueKind::Other;
}

std::string bashCompletions(const CommandFacts& root, std::span<const std::string> places) {
    std::vector<std::string> paths;
    std::string values, words;
    forEachCommand(root, [&](const CommandFacts& command) {
        if (command.path.size() > 1)
            paths.push_back(command.joined());
        std::vector<std::string> options;
        std::string argument;
        for (const OptionFacts& option : command.options) {
            const std::string reply = bashReply(option, root, places);
            if (option.isPositional) {
                argument = reply;
                continue;
            }
            options.insert(options.end(), option.names.begin(), option.names.end());
            std::vector<std::string> keys;
            for (const std::string& name : option.names)
                keys.push_back(command.joined() + ":" + name);
            if (!option.value.empty())
                values += fmt::format("        {}) {} return ;;\n", patterns(keys),
                                      reply.empty() ? "" : reply + ";");
        }
        if (!command.commands.empty())
            argument = fmt::format("_limen_words '{}'", fmt::join(namesOf(command.commands), " "));
        words += fmt::format(
            "        '{}')\n            if [[ $current == -* ]]; then _limen_words '{}'{}; fi ;;\n",
            command.joined(), fmt::join(options, " "), argument.empty() ? "" : "; else " + argument);
    });
    return kBashHead +
           fmt::format("            {}) path=\"$path ${{COMP_WORDS[i]}}\" ;;\n        esac\n    done\n"
                       "    case \"$path:$previous\" in\n{}    esac\n    case \"$path\" in\n{}    esac\n}}\n"
                       "complete -F _limen limen\n",
                       patterns(paths), values, words);
}

namespace {

/// Text inside of an _arguments specification, which is itself in single quotes.
std::string zshText(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\')
            result += '\\';
        result += c;
    }
    return inQuotes(result);
}

/// The action of a specification.
std::string zshAction(const OptionFacts& option, const CommandFacts& root,
                      std::span<const std::string> places) {
    const auto words = [](const auto& list) {
        return "(" + inQuotes(fmt::format("{}", fmt::join(list, " "))) + ")";
    };
    switch (valueKindOf(option)) {
    case ValueKind::Choice:
        return words(option.choices);
    case ValueKind::Place:
        return words(places);
    case ValueKind::Verb:
        return words(namesOf(root.commands));
    case ValueKind::File:
        return "_files";
    case ValueKind::Directory:
        return "_files -/";
    case ValueKind::None:
    case ValueKind::Other:
        break;
    }
    return " ";
}

std::string zshSpecification(const OptionFacts& option, const CommandFacts& root,
                             std::span<const std::string> places) {
    const std::string action = zshAction(option, root, places);
    if (option.isPositional)
        return fmt::format("'{}:{}:{}'", option.isRepeatable ? "*" : "", zshText(option.names.front()),
                           action);
    const std::string value =
        option.value.empty() ? "" : fmt::format(":{}:{}", zshText(option.value), action);
    const std::string text = fmt::format("[{}]{}", zshText(option.help), value);
    const std::string repeat = option.isRepeatable ? "*" : "";
    if (option.names.size() == 1)
        return fmt::format("'{}{}{}'", repeat, option.names.front(), text);
    return fmt::format("'({})'{{{}}}'{}'", fmt::join(option.names, " "), fmt::join(option.names, ","), text);
}

std::string zshFunction(const CommandFacts& command, const CommandFacts& root,
                        std::span<const std::string> places) {
    std::string text =
        fmt::format("_{}() {{\n    local context state state_descr line\n    typeset -A opt_args\n    "
                    "_arguments -C -S",
                    command.joined('_'));
    for (const OptionFacts& option : command.options)
        text += " \\\n        " + zshSpecification(option, root, places);
    if (command.commands.empty())
        return text + "\n}\n";
    text += " \\\n        '1:verb:->verb' \\\n        '*::argument:->argument'\n    case $state in\n        "
            "verb)\n"
            "            local -a verbs=(\n";
    for (const CommandFacts& verb : command.commands)
        text += fmt::format("                '{}:{}'\n", verb.name(), zshText(verb.brief));
    text += "            )\n            _describe verb verbs ;;\n        argument)\n            case "
            "$line[1] in\n";
    for (const CommandFacts& verb : command.commands)
        text += fmt::format("                {}) _{} ;;\n", verb.name(), verb.joined('_'));
    return text + "            esac ;;\n    esac\n}\n";
}

} // namespace

std::string zshCompletions(const CommandFacts& root, std::span<const std::string> places) {
    std::string text = "#compdef limen\n# zsh completion for limen, printed by: limen completions zsh\n";
    forEachCommand(root, [&](const CommandFacts& command) { text += zshFunction(command, root, places); });
    return text +
           "if [[ $funcstack[1] == _limen ]]; then\n    _limen \"$@\"\nelse\n    compdef _limen limen\nfi\n";
}

} // namespace limen::cli
