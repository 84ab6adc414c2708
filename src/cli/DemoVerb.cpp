#include "cli/Choices.h"
#include "cli/Verbs.h"
#include "engine/FrameMemory.h"
#include "output/OutputFile.h"
#include "worlds/Demo.h"
#include "worlds/Generated.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
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
    bool bare = false;
    bool tuned = false; ///< true if an option for generated worlds was given
};

/// A kind of generated world by its name, and the memory for writing it: bytes for each unit of size, measured on worlds of
/// the largest sizes, with a third as reserve.
struct NamedKind {
    std::string_view name;
    GeneratedKind kind;
    std::uint64_t bytesEach;
};
constexpr std::array kKinds{NamedKind{"dungeon", GeneratedKind::Dungeon, 6'000},
                            NamedKind{"town", GeneratedKind::Town, 190'000},
                            NamedKind{"complex", GeneratedKind::Complex, 110'000},
                            NamedKind{"terrain", GeneratedKind::Terrain, 200'000},
                            NamedKind{"map", GeneratedKind::Map, 8'500},
                            NamedKind{"skewed", GeneratedKind::Skewed, 140'000},
                            NamedKind{"thin", GeneratedKind::Thin, 20'000},
                            NamedKind{"nested", GeneratedKind::Nested, 40'000}};

/// Null: the built-in world.
const NamedKind* kindOf(std::string_view name) {
    const auto* const found =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const NamedKind& each) { return each.name == name; });
    return found != kKinds.end() ? found : nullptr;
}

std::uint64_t bytesToWrite(const NamedKind& kind, std::uint64_t size) {
    constexpr std::uint64_t kProgram = 100'000'000;
    return kProgram + size * kind.bytesEach;
}

Result<Exit> write(const DemoChoice& chosen, const Console& console) {
    const std::string& directory = chosen.output.empty() ? chosen.directory : chosen.output;
    const NamedKind* const kind = kindOf(chosen.kind);
    if (directory.empty() || !(chosen.directory.empty() || chosen.output.empty()))
        return fail(ErrorCode::BadArgument, "demo", "give one directory to write to, either DIR or -o DIR");
    if (kind == nullptr && chosen.tuned)
        return fail(ErrorCode::BadArgument, "demo",
                    "--size, --seed, --overlap and --bare need a generated world; choose one with --kind");
    if (kind != nullptr) {
        if (Result<void> fits =
                engine::checkMemory("--size", fmt::format("a {} of size {}", chosen.kind, chosen.size),
                                    bytesToWrite(*kind, chosen.size), engine::availableMemory());
            !fits)
            return Failure(fits.error());
    }
    if (Result<void> made = output::makeDirectory(directory); !made)
        return Failure(made.error());
    std::optional<Waiting> waiting(std::in_place, console, "writing the world");
    const Result<void> written =
        kind != nullptr ? worlds::writeGeneratedWorld(
                              {kind->kind, chosen.size, chosen.seed, chosen.overlap, !chosen.bare}, directory)
                        : worlds::writeBuiltInWorld(directory);
    waiting.reset();
    if (!written)
        return Failure(written.error());
    const std::string title =
        kind != nullptr ? fmt::format("a {} of size {}, seed {}", chosen.kind, chosen.size, chosen.seed)
                        : "the built-in world";
    console.wrote(directory, fmt::format("{} as client_portal.dat, client_cell_1.dat and world.json", title));
    return Exit::Done;
}

} // namespace

void addDemoVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("demo", "write the built-in world or a generated world as dat files");
    const auto chosen = std::make_shared<DemoChoice>();
    verb->add_option("DIR", chosen->directory, "write to this directory; create it if missing")
        ->type_name("");
    verb->add_option("-o,--output", chosen->output, "same as DIR (none)")->type_name("DIR");
    verb->add_option(
            "--kind", chosen->kind,
            "choose the world: built-in; dungeon: rooms, corridors and shafts; town: houses and streets; "
            "complex: convex cells with openings of every shape; terrain: cells that the ground passes "
            "through; map: all 255 x 255 landblocks with towns and dungeons; and three that are hard to "
            "draw: skewed: a complex with "
            "bent walls; thin: rooms with walls 0.1 to 5 mm apart; nested: rooms that overlap in loops "
            "(built-in)")
        ->type_name("built-in|dungeon|town|complex|terrain|map|skewed|thin|nested")
        ->check(
            oneOf({"built-in", "dungeon", "town", "complex", "terrain", "map", "skewed", "thin", "nested"}));
    CLI::Option* size = verb->add_option("--size", chosen->size,
                                         "set the number of cells (dungeon, complex, map, skewed, thin, "
                                         "nested), houses (town) or sites (terrain) (50)")
                            ->type_name("N");
    CLI::Option* seed =
        verb->add_option("--seed", chosen->seed,
                         "choose one world of this kind and size; equal seeds give equal worlds (1)")
            ->type_name("S");
    CLI::Option* overlap =
        verb->add_option("--overlap", chosen->overlap,
                         "dungeon: set the share of cells that overlap other cells, 0..0.05 (0.02)")
            ->type_name("SHARE");
    CLI::Option* bare = verb->add_flag(
        "--bare", chosen->bare,
        "write a generated world with small pictures and without furniture, which takes less time and space");
    verb->footer("Examples:\n  limen demo world\n  limen demo --kind town --size 20 --seed 7 -o town");
    verb->callback([&console, &choice, chosen, size, seed, overlap, bare] {
        chosen->tuned = size->count() + seed->count() + overlap->count() + bare->count() > 0;
        choice.run = [&console, chosen] { return write(*chosen, console); };
    });
}

} // namespace limen::cli
