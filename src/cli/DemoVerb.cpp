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
    bool tuned = false; ///< an option was given that generated worlds alone have
};

/// None: the built-in world.
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
        return fail(ErrorCode::BadArgument, "demo", "name one directory to write to: DIR or -o DIR");
    if (Result<void> made = output::makeDirectory(directory); !made)
        return tl::unexpected(made.error());
    const std::optional<GeneratedKind> kind = kindOf(chosen.kind);
    if (!kind && chosen.tuned)
        return fail(ErrorCode::BadArgument, "demo", "--size, --seed and --overlap go with another --kind");
    const Result<void> written =
        kind ? worlds::writeGeneratedWorld({*kind, chosen.size, chosen.seed, chosen.overlap}, directory)
             : worlds::writeBuiltInWorld(directory);
    if (!written)
        return tl::unexpected(written.error());
    const std::string what =
        kind ? fmt::format("A {} of size {}, seed {},", chosen.kind, chosen.size, chosen.seed)
             : "The built-in world";
    console.note(
        fmt::format("{} is in {}: client_portal.dat, client_cell_1.dat, world.json", what, directory));
    return Exit::Done;
}

} // namespace

void addDemoVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("demo", "writes the built-in or a generated world as dat files");
    const auto chosen = std::make_shared<DemoChoice>();
    verb->add_option("DIR", chosen->directory, "the directory to write to; made if it is missing")
        ->type_name("");
    verb->add_option("-o,--output", chosen->output, "the same, as an option")->type_name("DIR");
    verb->add_option(
            "--kind", chosen->kind,
            "built-in: the world the program carries; dungeon: rooms, corridors and shafts; town: houses "
            "and streets; complex: convex cells with openings of every shape; terrain: cells that the "
            "ground runs through; map: all 255 x 255 landblocks with towns and dungeons")
        ->type_name("KIND")
        ->check(CLI::IsMember({"built-in", "dungeon", "town", "complex", "terrain", "map"}))
        ->capture_default_str();
    CLI::Option* size =
        verb->add_option("--size", chosen->size,
                         "how many cells (dungeon, complex, map), houses (town) or sites (terrain)")
            ->type_name("N")
            ->capture_default_str();
    CLI::Option* seed = verb->add_option("--seed", chosen->seed,
                                         "which of the worlds of that kind and size; the same every time")
                            ->type_name("S")
                            ->capture_default_str();
    CLI::Option* overlap = verb->add_option("--overlap", chosen->overlap,
                                            "dungeon: share of cells that run through other cells, 0 to 0.05")
                               ->type_name("SHARE")
                               ->capture_default_str();
    verb->callback([&console, &choice, chosen, size, seed, overlap] {
        chosen->tuned = size->count() + seed->count() + overlap->count() > 0;
        choice.run = [&console, chosen] { return write(*chosen, console); };
    });
}

} // namespace limen::cli
