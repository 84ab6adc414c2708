#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

// The verbs and their options as plain data, from which help texts, manual pages and completions are made.
namespace limen::cli {

struct OptionFacts {
    std::vector<std::string> names; ///< "-o", "--output"; of a positional its name, "DIR"
    std::string value;              ///< the notation of the value, e.g. "WxH"; empty: a flag or a positional
    std::string help;
    std::string group;                ///< the heading in the help text
    std::vector<std::string> choices; ///< the fixed values, e.g. clear and rain
    bool isPositional = false, isRequired = false, isRepeatable = false;
};

struct CommandFacts {
    std::vector<std::string> path; ///< "limen", "dat", "ls"
    std::string brief;             ///< the description
    std::string notes;             ///< the text below the options, with the examples
    std::vector<OptionFacts> options;
    std::vector<CommandFacts> commands;

    [[nodiscard]] const std::string& name() const { return path.back(); }
    /// "limen dat ls", or with '-', the name of the manual page.
    [[nodiscard]] std::string joined(char separator = ' ') const;
};

/// Everything that `app`, which has the full path `path`, declares.
[[nodiscard]] CommandFacts factsOf(const CLI::App& app, std::vector<std::string> path);

/// The command at `names` below `root`; null: there is none.
[[nodiscard]] const CommandFacts* commandAt(const CommandFacts& root, const std::vector<std::string>& names);

/// Notes cut into paragraphs and into blocks of lines that begin with blanks. "Examples:" and "Exit codes:" begin a
/// paragraph.
struct NotesPart {
    bool isVerbatim = false;
    std::string text;
};
[[nodiscard]] std::vector<NotesPart> partsOf(const std::string& notes);

/// The page of `limen help`, at most `width` columns wide where words allow it.
[[nodiscard]] std::string helpPage(const CommandFacts& command, std::size_t width = 100);

} // namespace limen::cli
