#include "worlds/builtin/buildings/InnKit.h"

namespace limen::worlds::inn {

CellPlan innHall(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer, {.name = "hall", .min = {-7.7, 0.3, 0.0}, .max = {1.4, 6.4, kHeight}},
                     {{Side::North, kKitchenDoor}, {Side::East, kParlourDoor}, {Side::Ceiling, kShaft}},
                     {{f.fireplace, {{-7.69, kHearthY, 0.0}, 90.0}},
                      {k.p.breast, {{-7.69, kHearthY, 0.0}, 90.0}},
                      {addJoists(k.writer, 6.1, 5.2, 1.3), {{-5.0, 3.35, kHeight}, 90.0}},
                      {addJoists(k.writer, 2.5, 3.4, 1.1), {{-0.5, 1.55, kHeight}, 90.0}},
                      {k.p.post, {{-2.42, 2.88, 0.0}, 90.0}},
                      {k.p.post, {{-2.42, 5.72, 0.0}, 90.0}},
                      {k.p.bar, {{-0.75, 4.95, 0.0}, 0.0}},
                      {f.shelf, {{-1.6, 6.39, 0.0}, 0.0}},
                      {f.shelf, {{-0.3, 6.39, 0.0}, 0.0}},
                      {f.barrel, {{0.95, 6.0, 0.0}, 15.0}},
                      {f.stool, {{-1.9, 4.2, 0.0}, 10.0}},
                      {f.stool, {{-1.1, 4.15, 0.0}, 40.0}},
                      {f.stool, {{-0.3, 4.25, 0.0}, 75.0}},
                      {f.table, {{-5.0, 3.5, 0.0}, 90.0}},
                      {f.bench, {{-5.85, 3.5, 0.0}, 90.0}},
                      {f.bench, {{-4.15, 3.5, 0.0}, 90.0}},
                      {f.candle, {{-5.0, 3.7, 0.76}, 0.0}},
                      {f.jug, {{-4.85, 3.1, 0.76}, 0.0}},
                      {f.bowl, {{-5.2, 3.2, 0.76}, 0.0}},
                      {k.p.roundTable, {{-6.3, 1.35, 0.0}, 20.0}},
                      {f.stool, {{-5.5, 1.2, 0.0}, 0.0}},
                      {f.stool, {{-6.9, 0.85, 0.0}, 30.0}},
                      {f.candle, {{-6.3, 1.4, 0.76}, 0.0}},
                      {k.p.roundTable, {{-3.1, 1.3, 0.0}, 0.0}},
                      {f.chair, {{-3.9, 1.35, 0.0}, 80.0}},
                      {f.stool, {{-2.4, 0.9, 0.0}, 0.0}},
                      {f.jug, {{-3.2, 1.2, 0.76}, 0.0}},
                      {f.barrel, {{-7.25, 5.95, 0.0}, 40.0}},
                      {f.barrel, {{-6.5, 6.0, 0.0}, 110.0}},
                      {f.bench, {{1.1, 3.6, 0.0}, 90.0}},
                      {f.lantern, {{-5.65, 1.9, kHeight - 0.17}, 10.0}},
                      {f.lantern, {{-3.05, 4.6, kHeight - 0.17}, 35.0}},
                      {f.lantern, {{-1.633, 1.6, kHeight - 0.17}, 0.0}}});
}

CellPlan kitchen(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer,
                     {.name = "kitchen",
                      .min = {-7.7, 6.6, 0.0},
                      .max = {1.4, 10.7, kHeight},
                      .floor = Material::Flagstones},
                     {{Side::South, kKitchenDoor}, {Side::East, kBackDoor}},
                     {{addJoists(k.writer, 4.1, 9.1, 1.5), {{-3.15, 8.65, kHeight}, 90.0}},
                      {f.table, {{-3.6, 8.9, 0.0}, 0.0}},
                      {f.table, {{-1.85, 8.9, 0.0}, 0.0}},
                      {f.bowl, {{-3.9, 8.8, 0.76}, 0.0}},
                      {f.bowl, {{-2.2, 9.05, 0.76}, 50.0}},
                      {f.jug, {{-3.2, 9.1, 0.76}, 0.0}},
                      {f.candle, {{-2.75, 8.95, 0.76}, 0.0}},
                      {f.shelf, {{-2.6, 6.61, 0.0}, 180.0}},
                      {f.shelf, {{-1.2, 6.61, 0.0}, 180.0}},
                      {f.shelf, {{-4.4, 10.69, 0.0}, 0.0}},
                      {f.barrel, {{0.95, 10.2, 0.0}, 0.0}},
                      {f.barrel, {{0.2, 10.25, 0.0}, 80.0}},
                      {f.sacks, {{-6.9, 7.3, 0.0}, 0.0}},
                      {f.crate, {{-7.2, 10.25, 0.0}, 5.0}},
                      {f.crate, {{0.9, 7.05, 0.0}, 85.0}},
                      {f.stool, {{-2.9, 8.05, 0.0}, 0.0}},
                      {f.lantern, {{-0.88, 8.1, kHeight - 0.17}, 0.0}},
                      {f.lantern, {{-5.43, 8.9, kHeight - 0.17}, 25.0}}});
}

CellPlan passage(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer,
                     {.name = "passage",
                      .min = {1.6, 5.2, 0.0},
                      .max = {3.0, 10.7, kHeight},
                      .floor = Material::Flagstones},
                     {{Side::West, kBackDoor}, {Side::South, kPassageDoor}, {Side::East, kStairsDoor}},
                     {{f.crate, {{2.66, 6.75, 0.0}, 90.0}},
                      {f.barrel, {{2.6, 7.7, 0.0}, 90.0}},
                      {f.lantern, {{2.2, 7.6, kHeight}, 45.0}}});
}

CellPlan parlour(Kit& k) {
    const Furniture& f = k.f;
    return furnished(k.writer, {.name = "parlour", .min = {1.6, 0.3, 0.0}, .max = {7.7, 5.0, kHeight}},
                     {{Side::West, kParlourDoor}, {Side::North, kPassageDoor}, {Side::North, kStoreDoor}},
                     {{addJoists(k.writer, 4.7, 6.1, 1.5), {{4.65, 2.65, kHeight}, 90.0}},
                      {f.rug, {{4.6, 2.6, 0.0}, 0.0}},
                      {k.p.roundTable, {{4.6, 2.6, 0.014}, 15.0}},
                      {f.chair, {{4.5, 3.4, 0.014}, 5.0}},
                      {f.chair, {{5.4, 2.45, 0.014}, -95.0}},
                      {f.chair, {{4.4, 1.75, 0.014}, 175.0}},
                      {f.candle, {{4.65, 2.65, 0.774}, 0.0}},
                      {f.jug, {{4.35, 2.4, 0.774}, 0.0}},
                      {f.shelf, {{4.2, 4.99, 0.0}, 0.0}},
                      {f.chest, {{7.3, 4.45, 0.0}, -90.0}},
                      {f.bench, {{7.45, 1.1, 0.0}, 90.0}},
                      {f.lantern, {{3.89, 1.6, kHeight - 0.17}, 0.0}},
                      {f.lantern, {{5.41, 3.9, kHeight - 0.17}, 30.0}}});
}

CellPlan store(Kit& k) {
    const Furniture& f = k.f;
    const dat::RecordId railing = addRailing(k.writer, kDown.v1 - kDown.v0);
    return furnished(k.writer, {.name = "store", .min = {4.6, 5.2, 0.0}, .max = {7.7, 10.7, kHeight}},
                     {{Side::South, kStoreDoor}, {Side::Floor, kDown}},
                     {{railing, {{kDown.u1 + 0.06, kDown.v0, 0.0}, 0.0}},
                      {f.barrel, {{7.25, 5.7, 0.0}, 0.0}},
                      {f.barrel, {{7.3, 6.5, 0.0}, 70.0}},
                      {f.crate, {{7.2, 9.4, 0.0}, 90.0}},
                      {f.crate, {{7.15, 10.2, 0.0}, 84.0}},
                      {f.crate, {{7.2, 10.2, 0.58}, 95.0}},
                      {f.sacks, {{6.7, 10.3, 0.0}, 40.0}},
                      {f.lantern, {{6.6, 7.4, kHeight}, 0.0}}});
}

} // namespace limen::worlds::inn
