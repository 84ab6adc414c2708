#include "app/OutputFile.h"
#include "app/Verbs.h"
#include "demo/Demo.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace limen::app {

void addDemoVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("demo", "writes the built-in world as dat files");
    const auto directory = std::make_shared<std::string>();
    verb->add_option("DIR", *directory, "the directory to write to; made if it is missing")
        ->required()
        ->type_name("");
    verb->callback([&console, &choice, directory] {
        choice.run = [&console, directory]() -> Result<Exit> {
            if (Result<void> made = makeDirectory(*directory); !made)
                return tl::unexpected(made.error());
            if (Result<void> written = demo::writeBuiltInWorld(*directory); !written)
                return tl::unexpected(written.error());
            console.note(fmt::format(
                "The built-in world is in {}: client_portal.dat, client_cell_1.dat, world.json", *directory));
            return Exit::Done;
        };
    });
}

} // namespace limen::app
