#include "cli/Verbs.h"
#include "output/OutputFile.h"
#include "worlds/Demo.h"
#include "worlds/Generated.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace limen::cli {
namespace {

using worlds::GeneratedKind;

struct DemoChoice {
    std::string directory, output;
    std::string kind = "built-in";
    std::uint32_t size = 50, seed = 1;
    double overlap = 0.02;
    bool tuned = false; ///< true if an option for generated worlds was given
};

/// nullopt: the built-in world.
std::optional<GeneratedKind> kindOf(std::string_view name) {
    if (name == "dungeon")
        return GeneratedKind::Dungeon;
    if (name == "town")
        return GeneratedKind::Town;
    if (name == "complex")
        return GeneratedKind::Complex;
    if (name == "terrain")
        return GeneratedKind::Terrain;
    if (name == "map")
        return GeneratedKind::Map;
    return std::nullopt;
}

Result<Exit> write(const DemoChoice& chosen, const Console& console) {
    const std::string& directory = chosen.output.empty() ? chosen.directory : chosen.output;
    if (directory.empty() || !(chosen.directory.empty() || chosen.output.empty()))
        return fail(ErrorCode::BadArgument, "demo", "give one directory to write to, either DIR or -o DIR");
    if (Result<void> made = output::makeDirectory(directory); !made)
        return tl::unexpected(made.error());
    const std::optional<GeneratedKind> kind = kindOf(chosen.kind);
    if (!kind && chosen.tuned)
        return fail(ErrorCode::BadArgument, "demo",
                    "--size, --seed and --overlap need a generated world; choose one with --kind");
    const Result<void> written =
        kind ? worlds::writeGeneratedWorld({*kind, chosen.size, chosen.seed, chosen.overlap}, directory)
             : worlds::writeBuiltInWorld(directory);
    if (!written)
        return tl::unexpected(written.error());
    const std::string title =
        kind ? fmt::format("A {} of size {}, seed {},", chosen.kind, chosen.size, chosen.seed)
             : "The built-in world";
    console.note(fmt::format("{} was written to {}: client_portal.dat, client_cell_1.dat, world.json", title,
                             directory));
    return Exit::Done;
}

} // namespace

void addDemoVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("demo", "write the built-in world or a generated world as dat files");
    const auto chosen = std::make_shared<DemoChoice>();
    verb->add_option("DIR", chosen->directory, "write to this directory; create it if missing")
        ->type_name("");
    verb->add_option("-o,--output", chosen->output, "same as DIR")->type_name("DIR");
    verb->add_option(
            "--kind", chosen->kind,
            "choose the world: built-in; dungeon: rooms, corridors and shafts; town: houses and streets; "
            "complex: convex cells with openings of every shape; terrain: cells that the ground passes "
            "through; map: all 255 x 255 landblocks with towns and dungeons")
        ->type_name("KIND")
        ->check(CLI::IsMember({"built-in", "dungeon", "town", "complex", "terrain", "map"}))
        ->capture_default_str();
    CLI::Option* size =
        verb->add_option("--size", chosen->size,
                         "set the number of cells (dungeon, complex, map), houses (town) or sites (terrain)")
            ->type_name("N")
            ->capture_default_str();
    CLI::Option* seed =
        verb->add_option("--seed", chosen->seed,
                         "choose one world of this kind and size; equal seeds give equal worlds")
            ->type_name("S")
            ->capture_default_str();
    CLI::Option* overlap =
        verb->add_option("--overlap", chosen->overlap,
                         "dungeon: set the share of cells that overlap other cells, 0..0.05")
            ->type_name("SHARE")
            ->capture_default_str();
    verb->callback([&console, &choice, chosen, size, seed, overlap] {
        chosen->tuned = size->count() + seed->count() + overlap->count() > 0;
        choice.run = [&console, chosen] { return write(*chosen, console); };
    });
}

} // namespace limen::cli
