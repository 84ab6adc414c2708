#pragma once

#include "worlds/shapes/Panel.h"

namespace limen::worlds {

/// The exterior of a house with a thatched gable roof, timber-framed or of stone. In its coordinates the
/// ground floor is z = 0; the front wall is at y = 0 and looks south; the ridge is parallel to x.
struct HouseShell {
    double halfWidth = 6.0,
           depth = 10.0;            ///< outer size: x from -halfWidth to halfWidth, y from 0 to depth
    double wall = 0.3;              ///< thickness
    double base = -1.4, top = 2.75; ///< the walls' lower and upper end
    double pitch = 1.0;             ///< rise of the roof per metre
    double ground = -0.35;          ///< height of the ground
    bool chimney = true;
    double chimneyX = 0.0, chimneyY = 0.0;
    bool timbered = true; ///< posts, beams and braces on the walls
    Material walls = Material::Plaster;
    double upperFloor = 0.0; ///< top of the beam between two storeys; 0: one storey

    /// A hole through an outer wall. The portal is in the wall's inner face; the reveals belong to the
    /// exterior. Doors at z = 0 get steps.
    struct Hole {
        Side side = Side::South;
        Rect rect;
        bool door = false;
    };
    std::vector<Hole> holes;
};

/// The inner face of an outer wall: x or y of its plane.
[[nodiscard]] double innerPlane(const HouseShell& house, Side side);

/// The height of its chimney without the pot.
[[nodiscard]] double chimneyTop(const HouseShell& house);

/// Walls, reveals, portals (in the order of the holes), plinth, timbers, roof, chimney, steps.
[[nodiscard]] FaceMesh buildHouseShell(const HouseShell& house);

/// Adds a timber frame around an opening, on the wall's face at `at`. It extends `out` metres into the room
/// that the side faces (negative: away from it) and covers 3 mm of the opening's border.
void addFrame(FaceMesh& mesh, Side side, double at, const Rect& opening, double width, double out, bool sill);

} // namespace limen::worlds
