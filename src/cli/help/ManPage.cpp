#include "cli/help/ManPage.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::cli {
namespace {

/// Text as roff: '-' as a minus that can be copied, no line that begins with a control character.
std::string roff(const std::string& text) {
    std::string result;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\''))
            result += "\\&";
        begins = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '"')
            result += "\\(dq";
        else if (c == '\'')
            result += "\\(aq";
        else
            result += c;
    }
    return result;
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string synopsis(const CommandFacts& command) {
    std::string text = ".B " + roff(command.joined()) + "\n";
    for (const OptionFacts& option : command.options)
        if (option.isRequired && !option.isPositional)
            text += fmt::format(".B {}\n.I {}\n", roff(option.names.front()), roff(option.value));
    text += ".RI [ OPTIONS ]\n";
    for (const OptionFacts& option : command.options) {
        if (!option.isPositional)
            continue;
        const std::string name = roff(option.names.front());
        const std::string dots = option.isRepeatable ? " .\\|.\\|." : "";
        text += option.isRequired ? fmt::format(".IR {}{}\n", name, dots)
                                  : fmt::format(".RI [ {} {}]\n", name, dots.empty() ? "" : dots.substr(1));
    }
    return text + (command.commands.empty() ? "" : ".I VERB\n.RI [ ARGUMENTS ]\n");
}

std::string paragraphOf(const OptionFacts& option) {
    std::string head;
    for (const std::string& name : option.names)
        head += (head.empty() ? "" : ", ") +
                (option.isPositional ? "\\fI" + roff(name) + "\\fR" : "\\fB" + roff(name) + "\\fR");
    if (!option.value.empty())
        head += " \\fI" + roff(option.value) + "\\fR";
    return fmt::format(".TP\n{}\n{}\n", head,
                       roff(option.help + (option.isRequired && !option.isPositional ? " (required)" : "")));
}

std::string optionsOf(const CommandFacts& command) {
    std::string text;
    std::vector<std::string> groups;
    for (const OptionFacts& option : command.options)
        if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
            groups.push_back(option.group);
    if (!groups.empty())
        text += ".SH OPTIONS\n";
    for (const std::string& group : groups) {
        if (groups.size() > 1)
            text += ".SS " + roff(group) + "\n";
        for (const OptionFacts& option : command.options)
            if (option.group == group)
                text += paragraphOf(option);
    }
    return text;
}

std::string notesOf(const CommandFacts& command) {
    std::string text;
    for (const NotesPart& part : partsOf(command.notes))
        text +=
            part.isVerbatim ? ".PP\n.nf\n" + roff(part.text) + "\n.fi\n" : ".PP\n" + roff(part.text) + "\n";
    return text.empty() ? text : ".SH NOTES\n" + text.substr(4); // the heading begins a paragraph itself
}

std::string seeAlso(const CommandFacts& command, const CommandFacts& root) {
    std::vector<std::string> pages;
    if (command.path.size() > 1)
        pages.push_back(root.joined('-'));
    for (const CommandFacts& verb : command.commands)
        pages.push_back(verb.joined('-'));
    std::string text = ".SH SEE ALSO\n";
    for (std::size_t i = 0; i < pages.size(); ++i)
        text += fmt::format(".BR {} (1){}\n", roff(pages[i]), i + 1 < pages.size() ? "," : "");
    return pages.empty() ? "" : text;
}

} // namespace

std::string manPage(const CommandFacts& command, const CommandFacts& root, const std::string& version) {
    std::string page = fmt::format(".TH {} 1 \"\" \"limen {}\" \"User Commands\"\n",
                                   roff(upper(command.joined('-'))), roff(version));
    page += fmt::format(".SH NAME\n{} \\- {}\n", roff(command.joined('-')), roff(command.brief));
    page += ".SH SYNOPSIS\n" + synopsis(command);
    if (!command.commands.empty())
        page += ".SH VERBS\n";
    for (const CommandFacts& verb : command.commands)
        page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(verb.name()), roff(verb.brief));
    return page + optionsOf(command) + notesOf(command) + seeAlso(command, root);
}

} // namespace limen::cli
