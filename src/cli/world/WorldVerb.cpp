#include "cli/world/WorldVerbs.h"

#include <CLI/CLI.hpp>

namespace limen::cli {

void addWorldVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("world", "import, list, show, export and count the placed objects of a world");
    verb->require_subcommand(1);
    verb->footer(
        "Doors, people and travel portals are not in dat files. A world.db or a world.json beside the files\n"
        "has them. To read about one of the verbs: limen help world VERB.\n"
        "Examples:\n  limen world list\n  limen world stats");
    addWorldImportVerb(*verb, console, choice);
    addWorldListVerb(*verb, console, choice);
    addWorldShowVerb(*verb, console, choice);
    addWorldExportVerb(*verb, console, choice);
    addWorldStatsVerb(*verb, console, choice);
}

} // namespace limen::cli
