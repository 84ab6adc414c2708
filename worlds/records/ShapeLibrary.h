#pragma once

#include "worlds/records/FaceMesh.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The parts of a stored cell shape that an EnvCell refers to.
struct StoredShape {
    std::uint16_t environment = 0, structure = 0;
    std::vector<std::uint16_t> portalPolygons; ///< by portal
    std::vector<std::uint16_t> surfaces;       ///< low words, in the order of the shape's slots
};

/// Writes cell shapes into a world's Environments. The only writer of Environment records.
class ShapeLibrary {
public:
    /// `perEnvironment`: the number of shapes after which the next Environment begins.
    explicit ShapeLibrary(WorldRecords& records, std::size_t perEnvironment = kShapesPerEnvironment)
        : records_(records), perEnvironment_(perEnvironment) {}

    /// The next shape begins an Environment.
    void startEnvironment() { starts_ = true; }

    /// `faces` look inwards and have closed seams; portal faces are the cell's portals, in order. `cellTree`:
    /// see buildCellBsp and buildSolidCellBsp. Portals marked in `outwardPortals` (by index; may be shorter)
    /// are stored with the opposite winding.
    StoredShape add(std::vector<Face> faces, dat::BspTree cellTree,
                    const std::vector<bool>& outwardPortals = {});

private:
    static constexpr std::size_t kShapesPerEnvironment = 64;

    dat::Environment& environment();

    WorldRecords& records_;
    std::size_t perEnvironment_;
    bool starts_ = false;
};

} // namespace limen::worlds
