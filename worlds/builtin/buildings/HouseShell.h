#pragma once

#include "worlds/shapes/Panel.h"

namespace limen::worlds {

/// A house with a thatched gable roof, timber-framed or of stone, as seen from outside. Its own coordinates: z = 0 is the
/// ground floor, the front wall lies at y = 0 and looks south, the ridge runs along x.
struct HouseShell {
    double halfWidth = 6.0,
           depth = 10.0;            ///< outer measures: x from -halfWidth to halfWidth, y from 0 to depth
    double wall = 0.3;              ///< thickness
    double base = -1.4, top = 2.75; ///< the walls' lower and upper end
    double pitch = 1.0;             ///< rise of the roof per metre
    double ground = -0.35;          ///< where the terrain lies
    bool chimney = true;
    double chimneyX = 0.0, chimneyY = 0.0;
    bool timbered = true; ///< posts, beams and braces on the walls
    Material walls = Material::Plaster;
    double upperFloor = 0.0; ///< top of the beam between two storeys; 0: there is one storey

    /// A hole through an outer wall. The portal lies in the wall's inner face; the reveals belong to the
    /// exterior. Steps lead to doors at z = 0.
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

/// A timber frame around an opening, on the wall's face at `at`, reaching `out` metres from it into the room
/// that the side looks into (negative: away from it). Covers 3 mm of the opening's border.
void addFrame(FaceMesh& mesh, Side side, double at, const Rect& opening, double width, double out, bool sill);

} // namespace limen::worlds
