#include "worlds/generate/CellPlaces.h"
#include "worlds/generate/ComplexOpenings.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/Land.h"
#include "worlds/generate/Props.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/records/LandblockWriter.h"
#include "worlds/shapes/Shell.h"

#include <algorithm>
#include <array>
#include <utility>

namespace limen::worlds {

namespace {

constexpr dat::BlockCoord kNestedBlock{0x32, 0x40};
constexpr double kNestedStorey = 4.0; ///< metres
constexpr double kChordFrom =
    1.75; ///< metres from the axis: openings between neighbours end before, chords begin behind

/// Quarter `quadrant` of the plane begins at direction(quadrant) and ends at direction(quadrant + 1).
Vec3 direction(std::uint32_t quadrant) {
    constexpr std::array<std::array<double, 2>, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return {kDirections[quadrant % 4][0], kDirections[quadrant % 4][1], 0.0};
}

/// A box in one quadrant, with a corner on the axis.
struct NestedRoom {
    std::uint32_t quadrant = 0;
    double low = 0.0, high = 0.0;   ///< z
    std::array<double, 2> reach{};  ///< along the quadrant's first and second direction
    std::array<bool, 2> hasChord{}; ///< in the wall along that direction
    bool hasHatchUp = false;
};

/// The rooms of a storey, in the order of the way around the axis.
struct Ring {
    std::uint32_t first = 0, count = 0;
};

/// Storeys of rooms around an axis. Each storey is a ring that goes round several times before it closes, so every
/// fourth room is in the same place. Chords lead from one turn to another, hatches from storey to storey.
class NestedBuilder {
public:
    NestedBuilder(const Props& props, Random random) : props_(props), random_(random) {
        mix_.inexact = random_.chance(0.25) ? 0.3 : 0.0;
        mix_.reversed = 0.5;
    }

    /// At least `count` rooms, a multiple of four.
    BuildingPlan build(std::uint32_t count) {
        for (std::uint32_t turns = (count + 3) / 4; turns > 0;) {
            const std::uint32_t here = std::min(turns, 2 + random_.below(3));
            addRing(4 * here);
            turns -= here;
        }
        for (std::size_t s = 1; s < rings_.size(); ++s)
            chooseHatches(rings_[s - 1], rings_[s]);
        for (const Ring& ring : rings_)
            joinRing(ring);
        for (const auto& [lower, upper] : hatches_)
            openHatch(lower, upper);
        for (std::uint32_t r = 0; r < rooms_.size(); ++r)
            finish(r);
        return std::move(plan_);
    }

private:
    void addRing(std::uint32_t count) {
        const double low = kNestedStorey * static_cast<double>(rings_.size());
        rings_.push_back({static_cast<std::uint32_t>(rooms_.size()), count});
        for (std::uint32_t k = 0; k < count; ++k) {
            NestedRoom room;
            room.quadrant = k % 4;
            room.low = low;
            room.high = low + kNestedStorey + (random_.chance(0.5) ? 0.0 : 0.0625 * random_.below(24) - 1.0);
            for (double& reach : room.reach)
                reach = 3.5 + 0.0625 * random_.below(72);
            rooms_.push_back(room);
        }
        shells_.resize(rooms_.size());
        plan_.cells.resize(rooms_.size());
    }

    /// Chooses rooms of one quadrant in two storeys. The lower one gets its ceiling at the upper one's floor.
    void chooseHatches(const Ring& below, const Ring& above) {
        for (int tried = 0; tried < 4; ++tried) {
            const std::uint32_t k = random_.below(below.count);
            const std::uint32_t upper = above.first + 4 * random_.below(above.count / 4) + k % 4;
            const bool isTaken = std::any_of(hatches_.begin(), hatches_.end(),
                                             [&](const auto& hatch) { return hatch[1] == upper; });
            if (isTaken || std::exchange(rooms_[below.first + k].hasHatchUp, true))
                continue;
            rooms_[below.first + k].high = rooms_[upper].low;
            hatches_.push_back({below.first + k, upper});
        }
    }

    void joinRing(const Ring& ring) {
        for (std::uint32_t k = 0; k < ring.count; ++k)
            joinAround(ring.first + k, ring.first + (k + 1) % ring.count, 0.0, kChordFrom - 0.25);
        for (std::uint32_t k = 0; ring.count > 4 && k < ring.count; ++k)
            if (random_.chance(0.3))
                addChord(ring, k);
    }

    /// An opening from room `k` of a ring to another turn, unless one of the walls has a chord.
    void addChord(const Ring& ring, std::uint32_t k) {
        const std::uint32_t other = (k + 1 + 4 * (1 + random_.below(ring.count / 4 - 1))) % ring.count;
        NestedRoom &here = rooms_[ring.first + k], &there = rooms_[ring.first + other];
        if (here.hasChord[1] || there.hasChord[0])
            return;
        here.hasChord[1] = there.hasChord[0] = true;
        joinAround(ring.first + k, ring.first + other, kChordFrom, std::min(here.reach[1], there.reach[0]));
    }

    /// Joins a room to one in the next quadrant, between two distances from the axis.
    void joinAround(std::uint32_t a, std::uint32_t b, double from, double to) {
        const NestedRoom &first = rooms_[a], &second = rooms_[b];
        const Vec3 along = direction(first.quadrant + 1);
        const auto upright = [&](double begin, double end, double high) {
            return Polygon{along * begin + Vec3(0, 0, first.low), along * end + Vec3(0, 0, first.low),
                           along * end + Vec3(0, 0, high), along * begin + Vec3(0, 0, high)};
        };
        const std::array<Polygon, 2> walls{upright(0.0, first.reach[1], first.high),
                                           upright(0.0, second.reach[0], second.high)};
        open(a, b, upright(from, to, std::min(first.high, second.high)), walls);
    }

    void openHatch(std::uint32_t a, std::uint32_t b) {
        const NestedRoom &lower = rooms_[a], &upper = rooms_[b];
        const Vec3 u = direction(lower.quadrant), v = direction(lower.quadrant + 1), z(0, 0, upper.low);
        const auto level = [&](double s, double t) {
            return Polygon{z, u * s + z, u * s + v * t + z, v * t + z};
        };
        const std::array<Polygon, 2> walls{level(lower.reach[0], lower.reach[1]),
                                           level(upper.reach[0], upper.reach[1])};
        open(a, b, level(std::min(lower.reach[0], upper.reach[0]), std::min(lower.reach[1], upper.reach[1])),
             walls);
    }

    void open(std::uint32_t a, std::uint32_t b, const Polygon& face, std::span<const Polygon> walls) {
        for (const OpeningPair& pair : makeOpenings(face, walls, mix_, random_)) {
            const auto i = static_cast<std::uint16_t>(plan_.cells[a].links.size());
            const auto j = static_cast<std::uint16_t>(plan_.cells[b].links.size());
            add(a, pair.first, {b, j, pair.exact});
            add(b, pair.second, {a, i, pair.exact});
        }
    }

    void add(std::uint32_t room, const Polygon& polygon, CellLink link) {
        link.insidePositive = !random_.chance(mix_.reversed);
        plan_.cells[room].links.push_back(link);
        shells_[room].openings.push_back(polygon);
    }

    void finish(std::uint32_t r) {
        const NestedRoom& room = rooms_[r];
        const Vec3 far =
            direction(room.quadrant) * room.reach[0] + direction(room.quadrant + 1) * room.reach[1];
        const Vec3 low = glm::min(far, Vec3(0.0)) + Vec3(0, 0, room.low),
                   high = glm::max(far, Vec3(0.0)) + Vec3(0, 0, room.high);
        constexpr std::array kWalls{Material::StoneWall, Material::Brick, Material::InnerPlaster,
                                    Material::Rock};
        shells_[r].walls = boxShell(low, high, kWalls[random_.below(kWalls.size())]).walls;
        CellPlan& cell = plan_.cells[r];
        cell.faces = facesOf(shells_[r]);
        cell.eye = (low + high) * 0.5;
        if (random_.chance(0.6))
            cell.statics.push_back(
                {pickProp(props_, random_),
                 {far * random_.between(0.2, 0.8) + Vec3(0, 0, room.low), random_.between(0.0, 360.0)}});
    }

    const Props& props_;
    Random random_;
    OpeningMix mix_;
    std::vector<NestedRoom> rooms_;
    std::vector<Ring> rings_;
    std::vector<Shell> shells_;                         ///< by room
    std::vector<std::array<std::uint32_t, 2>> hatches_; ///< lower and upper room
    BuildingPlan plan_;
};

} // namespace

WorldRecords buildNested(const GeneratedSpec& spec) {
    WorldRecords records;
    addGeneratedMaterials(records, spec.furnished);
    ModelWriter writer(records);
    const Props props = addProps(writer, spec.furnished);
    BuildingPlan plan = NestedBuilder(props, Random(seedOf(spec))).build(spec.size);
    const std::vector<CellPlan> cells = plan.cells;
    const Placement at{{96.0, 96.0, 0.125}, 0.0};
    LandblockWriter block(writer, kNestedBlock, kGeneratedCells);
    const dat::RecordId first = block.add(withClosedSeams(std::move(plan)), at).front();
    WorldNotes notes;
    notePlaces({"room", kNestedBlock, at, first}, cells, notes);
    block.finish();
    Land(kNestedBlock, 1, 1, 0).addTo(records);
    records.worldFile = notes.take();
    return records;
}

} // namespace limen::worlds
