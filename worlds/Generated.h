#pragma once

#include "core/Error.h"

#include <cstdint>
#include <filesystem>

namespace limen::worlds {

/// What a generated world is made of.
enum class GeneratedKind : std::uint8_t {
    Dungeon, ///< rooms, corridors and shafts on a jittered lattice; no landscape
    Town,    ///< houses with doors, windows and cellars along streets, on land
    Complex, ///< a box cut into convex cells by tilted planes, with convex openings of every shape
    Terrain, ///< cellars, tunnels, towers and yards: cells that the ground runs through
    Map      ///< all 255 x 255 landblocks, towns here and there, dungeons of some hundred cells in the west
};

/// Which world to generate. The files depend on nothing else, byte for byte.
struct GeneratedSpec {
    GeneratedKind kind = GeneratedKind::Dungeon;
    /// Cells of a dungeon or map (to 1,000,000) or complex (to 5,000), houses of a town (to 2,000), sites of a
    /// terrain (to 500). Of a map about as many.
    std::uint32_t size = 50;
    std::uint32_t seed = 1;
    /// Share of the cells of dungeons, 0..0.05, that are corridors straight through other rooms: cells that overlap in space.
    double overlapShare = 0.02;
};

/// Writes a generated world to `directory` (made if missing): `client_portal.dat`, `client_cell_1.dat`,
/// `world.json`. Errors: a size of 0 or beyond the kind's limit, a share out of range; the directory or a file cannot
/// be written. Cost: about 10 s for 100,000 cells.
[[nodiscard]] Result<void> writeGeneratedWorld(const GeneratedSpec& spec,
                                               const std::filesystem::path& directory);

} // namespace limen::worlds
