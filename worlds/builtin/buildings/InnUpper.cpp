#include "worlds/builtin/buildings/InnKit.h"

namespace limen::worlds::inn {

CellPlan stairs(Kit& k) {
    return furnished(
        k.writer,
        {.name = "stairs", .min = {3.2, 5.2, 0.0}, .max = {4.4, 10.7, kTop}, .floor = Material::Flagstones},
        {{Side::West, kStairsDoor}, {Side::West, kLandingDoor}},
        {{k.p.stairs, {{kUpX, kStairsHead, kUpper}, 0.0}},
         {k.f.barrel, {{3.95, 10.25, 0.0}, 0.0}},
         {k.f.lantern, {{kUpX, 7.2, kTop}, 0.0}}});
}

CellPlan landing(Kit& k) {
    const Furniture& f = k.f;
    const dat::RecordId side = addRailing(k.writer, kShaft.v1 - kShaft.v0);
    const dat::RecordId end = addRailing(k.writer, kShaft.u1 - kShaft.u0);
    return furnished(k.writer, {.name = "landing", .min = {-2.6, 0.3, kUpper}, .max = {3.0, 10.7, kTop}},
                     {{Side::East, kLandingDoor},
                      {Side::East, kEastRoomDoor},
                      {Side::West, kWestRoomDoor},
                      {Side::West, kNorthRoomDoor},
                      {Side::Floor, kShaft}},
                     {{side, {{kShaft.u0 - 0.06, kShaft.v0, kUpper}, 0.0}},
                      {side, {{kShaft.u1 + 0.06, kShaft.v0, kUpper}, 0.0}},
                      {end, {{kShaft.u0, kShaft.v0 - 0.06, kUpper}, -90.0}},
                      {end, {{kShaft.u0, kShaft.v1 + 0.06, kUpper}, -90.0}},
                      {addJoists(k.writer, 5.6, 10.4, 1.6), {{0.2, 5.5, kTop}, 0.0}},
                      {f.bench, {{2.75, 5.0, kUpper}, 90.0}},
                      {f.chest, {{-1.7, 10.35, kUpper}, 0.0}},
                      {f.shelf, {{2.98, 7.4, kUpper}, -90.0}},
                      {f.table, {{-1.3, 8.9, kUpper}, 90.0}},
                      {f.chair, {{-0.5, 8.9, kUpper}, -88.0}},
                      {f.candle, {{-1.3, 9.2, kUpper + 0.76}, 0.0}},
                      {f.rug, {{1.3, 8.7, kUpper}, 90.0}},
                      {f.lantern, {{1.9, 4.6, kTop}, 0.0}},
                      {f.lantern, {{0.9, 9.4, kTop}, 20.0}}});
}

CellPlan westRoom(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer, {.name = "west room", .min = {-7.7, 0.3, kUpper}, .max = {-2.8, 5.3, kTop}},
                     {{Side::East, kWestRoomDoor}},
                     {{k.p.upperBreast, {{-7.69, kHearthY, kUpper}, 90.0}},
                      {f.bed, {{-6.9, 1.42, kUpper}, 180.0}},
                      {f.bed, {{-4.2, 4.2, kUpper}, 0.0}},
                      {f.chest, {{-5.5, 4.95, kUpper}, 0.0}},
                      {f.rug, {{-4.7, 2.0, kUpper}, 0.0}},
                      {f.stool, {{-3.3, 4.7, kUpper}, 0.0}},
                      {f.candle, {{-3.3, 4.7, kUpper + 0.45}, 0.0}},
                      {f.lantern, {{-5.2, 2.8, kTop}, 10.0}}});
}

CellPlan northRoom(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer, {.name = "north room", .min = {-7.7, 5.5, kUpper}, .max = {-2.8, 10.7, kTop}},
                     {{Side::East, kNorthRoomDoor}},
                     {{f.bed, {{-3.6, 9.55, kUpper}, 0.0}},
                      {f.bed, {{-6.9, 6.7, kUpper}, 180.0}},
                      {f.table, {{-6.7, 10.1, kUpper}, 0.0}},
                      {f.chair, {{-6.6, 9.3, kUpper}, 178.0}},
                      {f.bowl, {{-6.9, 10.15, kUpper + 0.76}, 0.0}},
                      {f.candle, {{-6.35, 10.2, kUpper + 0.76}, 0.0}},
                      {f.chest, {{-4.7, 5.9, kUpper}, 180.0}},
                      {f.rug, {{-5.0, 8.1, kUpper}, 90.0}},
                      {f.lantern, {{-5.2, 7.9, kTop}, 0.0}}});
}

CellPlan eastRoom(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer, {.name = "east room", .min = {3.2, 0.3, kUpper}, .max = {7.7, 5.0, kTop}},
                     {{Side::West, kEastRoomDoor}},
                     {{f.bed, {{6.9, 3.85, kUpper}, 0.0}},
                      {f.shelf, {{5.2, 4.99, kUpper}, 0.0}},
                      {f.table, {{5.2, 0.95, kUpper}, 0.0}},
                      {f.chair, {{5.1, 1.75, kUpper}, 4.0}},
                      {f.jug, {{5.5, 0.95, kUpper + 0.76}, 0.0}},
                      {f.candle, {{4.8, 0.9, kUpper + 0.76}, 0.0}},
                      {f.rug, {{4.9, 3.2, kUpper}, 0.0}},
                      {f.chest, {{3.75, 4.65, kUpper}, 0.0}},
                      {f.lantern, {{5.3, 2.6, kTop}, 0.0}}});
}

} // namespace limen::worlds::inn
