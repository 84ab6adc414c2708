#include "cli/Choices.h"
#include "cli/world/PlacedImport.h"
#include "cli/world/WorldVerbs.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace limen::cli {

void addWorldImportVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("import", "write a world.db from the community's world database");
    const auto arguments = std::make_shared<PlacedImport>();
    verb->add_option("SOURCE", arguments->sources,
                     "read these directories, archives or files of SQL, or this server; later paths replace "
                     "earlier ones")
        ->required()
        ->type_name("")
        ->check(notEmpty());
    verb->add_option("--dat", arguments->dat, "write the file beside these dat files (the working directory)")
        ->type_name("DIR");
    verb->add_option("-o,--output", arguments->output, "write this file (world.db)")->type_name("FILE");
    verb->add_option("--option-file", arguments->optionFile,
                     "read user and password of the server from this option file of MySQL (none)")
        ->type_name("FILE");
    verb->footer(
        "The files of the core come first, then those of the patches. A second import writes only the "
        "landblocks\n"
        "and templates that differ. A server is given as mariadb://USER@HOST/DATABASE or, for a socket, as\n"
        "mariadb://USER@/DATABASE?socket=PATH; the password is in the variable MYSQL_PWD or in an option "
        "file.\n"
        "The server is only read. Where world.db stands beside the dat files, every verb shows its objects.\n"
        "Examples:\n  limen world import core patches --dat DIR\n"
        "  limen world import mariadb://ann@localhost/ace_world -o world.db");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return importPlaced(*arguments, console); };
    });
}

} // namespace limen::cli
