#include "worlds/builtin/dungeon/DungeonHub.h"

namespace limen::worlds {

namespace {

constexpr double kPitShaft = 5.0; ///< metres from the pit's middle to its walls
constexpr double kPitOuter = 8.0; ///< metres from the pit's middle to the galleries' outer walls
constexpr double kStorey = 10.0;  ///< metres from gallery to gallery
constexpr double kCellHeight = 5.0, kGalleryHeight = 4.0;
constexpr std::size_t kFloors = 3, kShaftCells = 7;

/// Eight cells around the shaft, counter-clockwise, beginning with the eastern one; those with odd indices
/// are corners.
using Gallery = std::array<std::size_t, 8>;

Vec3 pitAt(double x, double y, double z) {
    return {kPitX + x, kPitY + y, z};
}

Gallery addGallery(CellComplex& complex, double z, std::size_t shaft) {
    struct Box {
        double x0, y0, x1, y1;
    };
    constexpr std::array<Box, 8> kBoxes{{{kPitShaft, -kPitShaft, kPitOuter, kPitShaft},
                                         {kPitShaft, kPitShaft, kPitOuter, kPitOuter},
                                         {-kPitShaft, kPitShaft, kPitShaft, kPitOuter},
                                         {-kPitOuter, kPitShaft, -kPitShaft, kPitOuter},
                                         {-kPitOuter, -kPitShaft, -kPitShaft, kPitShaft},
                                         {-kPitOuter, -kPitOuter, -kPitShaft, -kPitShaft},
                                         {-kPitShaft, -kPitOuter, kPitShaft, -kPitShaft},
                                         {kPitShaft, -kPitOuter, kPitOuter, -kPitShaft}}};
    constexpr double kMiddle = 0.5 * (kPitShaft + kPitOuter);
    constexpr std::array<std::array<double, 2>, 8> kSeams{{{kMiddle, kPitShaft},
                                                           {kPitShaft, kMiddle},
                                                           {-kPitShaft, kMiddle},
                                                           {-kMiddle, kPitShaft},
                                                           {-kMiddle, -kPitShaft},
                                                           {-kPitShaft, -kMiddle},
                                                           {kPitShaft, -kMiddle},
                                                           {kMiddle, -kPitShaft}}};
    Gallery gallery{};
    for (std::size_t k = 0; k < gallery.size(); ++k) {
        const Box& b = kBoxes[k];
        gallery[k] = addBoxCell(complex, "pit.gallery", pitAt(b.x0, b.y0, z),
                                pitAt(b.x1, b.y1, z + kGalleryHeight), kMasonry);
    }
    for (std::size_t k = 0; k < gallery.size(); ++k) {
        const bool alongX = std::abs(kSeams[k][1]) == kPitShaft; // the seam is at y = +-kPitShaft
        complex.join(gallery[k], gallery[(k + 1) % 8],
                     rectOutline({pitAt(kSeams[k][0], kSeams[k][1], z),
                                  alongX ? Vec3(1, 0, 0) : Vec3(0, 1, 0), 0.5 * (kPitOuter - kPitShaft)},
                                 kGalleryHeight));
    }
    // From each side two openings over a parapet lead into one cell of the shaft.
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 out = k == 0   ? Vec3(1, 0, 0)
                         : k == 1 ? Vec3(0, 1, 0)
                         : k == 2 ? Vec3(-1, 0, 0)
                                  : Vec3(0, -1, 0);
        const Vec3 across{std::abs(out.y), std::abs(out.x), 0.0};
        for (const double side : {-2.25, 2.25}) {
            complex.join(gallery[2 * k], shaft,
                         archOutline({pitAt(0, 0, z + 0.875) + out * kPitShaft + across * side, across, 1.5},
                                     1.25, 2.5));
        }
    }
    return gallery;
}

/// Adds a ramp one storey down, outside the galleries' western (`side` -1) or eastern (1) wall, from the
/// northern corner to the southern one below.
void addRamp(CellComplex& complex, const DungeonProps& props, const Gallery& upper, const Gallery& lower,
             double z, double side) {
    const double wall = side * kPitOuter;
    const auto box = [&](const char* name, double x0, double y0, double x1, double y1, double floor) {
        return addBoxCell(complex, name, pitAt(std::min(side * x0, side * x1), y0, floor),
                          pitAt(std::max(side * x0, side * x1), y1, floor + kGalleryHeight), kBareRock);
    };
    const std::size_t top = box("pit.landing", kPitOuter, kPitShaft, kPitOuter + 4.0, kPitOuter, z);
    complex.join(
        upper[side < 0.0 ? 3 : 1], top,
        rectOutline({pitAt(wall, 0.5 * (kPitShaft + kPitOuter), z), {0, 1, 0}, 1.5}, kGalleryHeight));
    const Outline section = rectOutline({pitAt(side * (kPitOuter + 2.0), kPitShaft, z), {1, 0, 0}, 1.5}, 3.5);
    const Vec3 step{0.0, -9.0, -0.5 * kStorey};
    const std::size_t ramp = complex.addRun("pit.ramp", section, step, 2, kBareRock);
    complex.join(top, ramp, section);
    Outline end = section;
    for (Vec3& p : end)
        p += step * 2.0;
    const double y = kPitShaft - 18.0;
    const double below = z - kStorey;
    const std::size_t bottom = box("pit.landing", kPitShaft, y - 4.0, kPitOuter + 4.0, y, below);
    complex.join(ramp + 1, bottom, end);
    const std::size_t back = box("pit.passage", kPitShaft, y, kPitOuter, -kPitOuter, below);
    const double middle = side * 0.5 * (kPitShaft + kPitOuter);
    complex.join(bottom, back, rectOutline({pitAt(middle, y, below), {1, 0, 0}, 1.5}, kGalleryHeight));
    complex.join(back, lower[side < 0.0 ? 5 : 7],
                 rectOutline({pitAt(middle, -kPitOuter, below), {1, 0, 0}, 1.5}, kGalleryHeight));
    hangTorch(complex, bottom, props, pitAt(middle, y - 4.0, below + 1.9), {0.0, -1.0, 0.0});
    hangTorch(complex, top, props, pitAt(side * (kPitOuter + 2.0), kPitOuter, z + 1.9), {0.0, 1.0, 0.0});
}

std::size_t addShaft(CellComplex& complex) {
    const double bottom = kDungeonFloor - 30.0;
    const std::vector<Vec2> square =
        rectangle(kPitX - kPitShaft, kPitY - kPitShaft, kPitX + kPitShaft, kPitY + kPitShaft);
    return complex.addRun("pit", levelOutline(square, bottom), {0.0, 0.0, kCellHeight}, kShaftCells,
                          {Material::WaterDark, Material::StoneWall, Material::Rock});
}

} // namespace

void addPit(CellComplex& complex, const DungeonProps& props, const Ring& ring, DungeonParts& parts) {
    parts.pit = addShaft(complex);
    parts.pitCount = kShaftCells;
    std::array<Gallery, kFloors> galleries{};
    for (std::size_t k = 0; k < kFloors; ++k) {
        const double z = kDungeonFloor - kStorey * static_cast<double>(k);
        galleries[k] = addGallery(complex, z, parts.pit + 6 - 2 * k);
        for (std::size_t s = 0; s < 4; ++s) {
            const Vec3 out = s == 0   ? Vec3(1, 0, 0)
                             : s == 1 ? Vec3(0, 1, 0)
                             : s == 2 ? Vec3(-1, 0, 0)
                                      : Vec3(0, -1, 0);
            const Vec3 across{std::abs(out.y), std::abs(out.x), 0.0};
            hangTorch(complex, galleries[k][2 * s], props,
                      pitAt(0, 0, z + 1.9) + out * kPitOuter + across * 3.0, out);
            hangTorch(complex, parts.pit + 6 - 2 * k, props, pitAt(0, 0, z + 2.1) + out * kPitShaft, out);
        }
    }
    parts.gallery = galleries[0][0];
    addRamp(complex, props, galleries[0], galleries[1], kDungeonFloor, -1.0);
    addRamp(complex, props, galleries[1], galleries[2], kDungeonFloor - kStorey, 1.0);
    // The way from the ring into the highest gallery.
    const Vec3 foot = ringRoomMiddle(RingRoom::West) - Vec3(kRingRoomReach, 0.0, 0.0);
    const double length = foot.x - (kPitX + kPitOuter);
    const Vec3 step{-0.25 * length, 0.0, 0.0};
    const Outline door = corridorOutline(foot, {0, 1, 0});
    const std::size_t way = complex.addRun("pit.way", door, step, 4, kMasonry);
    complex.join(ring.at(RingRoom::West), way, door);
    complex.join(way + 3, parts.gallery, corridorOutline(foot + step * 4.0, {0, 1, 0}));
    hangTorch(complex, way + 1, props, foot + step * 1.5 + Vec3(0.0, 1.25, 1.05), {0.0, 1.0, 0.0});
}

} // namespace limen::worlds
