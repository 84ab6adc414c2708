#pragma once

#include "core/Error.h"

#include <cstdint>
#include <filesystem>

namespace limen::worlds {

enum class GeneratedKind : std::uint8_t {
    Dungeon, ///< rooms, corridors and shafts on a jittered lattice; no land
    Town,    ///< houses with doors, windows and cellars along streets, on land
    Complex, ///< a box cut into convex cells by tilted planes, with convex openings of every shape
    Terrain, ///< cellars, tunnels, towers and yards: cells that intersect the ground
    Map,     ///< all 255 x 255 landblocks: some towns, and dungeons of some hundred cells in the west
    Skewed,  ///< a complex with corners rounded to a grid of up to 2 mm, so that its walls are bent
    Thin,    ///< a building of rooms with walls 0.1 to 5 mm apart, on land
    Nested   ///< rooms around an axis that overlap: the way around it closes after several turns
};

/// The parameters of a generated world. Every byte of the files follows from them.
struct GeneratedSpec {
    GeneratedKind kind = GeneratedKind::Dungeon;
    /// The number of cells of a dungeon (at most 1,000,000), complex or skewed complex (5,000), of houses of a
    /// town (2,000), of sites of a terrain (500). For a map, about the number of cells (1,000,000). Of thin (400) and
    /// nested (2,000) worlds, the least number of cells.
    std::uint32_t size = 50;
    std::uint32_t seed = 1;
    /// The share of a dungeon's cells, 0..0.05, that are corridors through other rooms. Such cells overlap in
    /// space.
    double overlapShare = 0.02;
    /// With the built-in world's pictures, furniture and lights. Else pictures of 32 x 32 texels and few props, which are
    /// quick to make. Cells, portals, doors and places are the same.
    bool furnished = false;
};

/// Writes a generated world to `directory` (made if missing): `client_portal.dat`, `client_cell_1.dat`,
/// `world.json`. Errors: the size is 0 or beyond the kind's limit; the share is out of range; the directory
/// or a file cannot be written. Cost: about 10 s for 100,000 cells.
[[nodiscard]] Result<void> writeGeneratedWorld(const GeneratedSpec& spec,
                                               const std::filesystem::path& directory);

} // namespace limen::worlds
