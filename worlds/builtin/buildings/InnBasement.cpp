#include "worlds/builtin/buildings/InnKit.h"

namespace limen::worlds::inn {

CellPlan basementStairs(Kit& k) {
    CellPlan cell = furnished(k.writer,
                              {.name = "basement stairs",
                               .min = {kDown.u0, kDown.v0, kBasement},
                               .max = {kDown.u1, kDown.v1, 0.0},
                               .floor = Material::Flagstones,
                               .walls = Material::StoneWall},
                              {{Side::Ceiling, kDown}, {Side::West, kBasementDoor}},
                              {{addStairs(k.writer, {}), {{kDownX, kDownHead, 0.0}, 0.0}}});
    return cell;
}

CellPlan basement(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer,
                     {.name = "basement",
                      .min = {-1.5, 4.2, kBasement},
                      .max = {4.6, 10.3, -0.45},
                      .floor = Material::Flagstones,
                      .walls = Material::StoneWall,
                      .ceiling = Material::OldPlanks},
                     {{Side::East, kBasementDoor}, {Side::West, kVaultArch}},
                     {{addJoists(k.writer, 6.1, 6.1, 1.4), {{1.55, 7.25, -0.45}, 0.0}},
                      {k.p.rack, {{1.6, 10.29, kBasement}, 0.0}},
                      {k.p.rack, {{1.5, 4.21, kBasement}, 180.0}},
                      {f.barrel, {{4.1, 4.7, kBasement}, 0.0}},
                      {f.barrel, {{4.1, 5.5, kBasement}, 50.0}},
                      {f.crate, {{3.3, 4.6, kBasement}, 0.0}},
                      {f.sacks, {{-0.9, 9.7, kBasement}, 0.0}},
                      {f.table, {{2.3, 7.2, kBasement}, 90.0}},
                      {f.stool, {{1.5, 7.4, kBasement}, 0.0}},
                      {f.jug, {{2.3, 7.6, kBasement + 0.76}, 0.0}},
                      {f.candle, {{2.4, 7.0, kBasement + 0.76}, 0.0}},
                      {f.lantern, {{0.2, 7.9625, -0.62}, 0.0}},
                      {f.lantern, {{2.3, 6.5625, -0.62}, 30.0}}});
}

CellPlan vault(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer,
                     {.name = "vault",
                      .min = {-7.4, 4.6, kBasement},
                      .max = {-1.7, 9.9, -0.45},
                      .floor = Material::Flagstones,
                      .walls = Material::StoneWall,
                      .ceiling = Material::OldPlanks},
                     {{Side::East, kVaultArch}},
                     {{addJoists(k.writer, 5.7, 5.3, 1.3), {{-4.55, 7.25, -0.45}, 0.0}},
                      {k.p.rack, {{-4.6, 9.89, kBasement}, 0.0}},
                      {k.p.rack, {{-4.6, 4.61, kBasement}, 180.0}},
                      {k.p.rack, {{-7.39, 7.25, kBasement}, 90.0}},
                      {f.chest, {{-2.3, 9.3, kBasement}, 0.0}},
                      {f.crate, {{-2.3, 5.2, kBasement}, 20.0}},
                      {f.candle, {{-2.3, 5.2, kBasement + 0.58}, 0.0}},
                      {f.lantern, {{-4.6, 6.6, -0.62}, 0.0}}});
}

} // namespace limen::worlds::inn
