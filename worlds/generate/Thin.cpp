#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/generate/CellPlaces.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/Land.h"
#include "worlds/generate/Props.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/records/Carve.h"
#include "worlds/records/LandblockWriter.h"
#include "worlds/shapes/Panel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::worlds {

namespace {

constexpr dat::BlockCoord kThinBlock{0x34, 0x40};
constexpr int kThinGround = 40;    ///< index of the ground's height
constexpr double kThinFoot = -1.0; ///< the outer walls' lower end

constexpr double kMostGap = 0.005; ///< metres
/// Worlds of odd seeds have gaps that the picture must keep apart, the others narrower ones, too, which the loader may weld.
double leastGapOf(std::uint32_t seed) {
    return seed % 2 == 1 ? 0.0005 : 0.0001;
}

/// An opening of a room. The wall around it is up to some millimetres before the opening's plane.
struct ThinOpening {
    Side side = Side::South;
    Rect rect;
    double plane = 0.0; ///< of the portal
    CellLink link;
};

struct ThinRoom {
    Vec3 min{0.0}, max{0.0};
    std::vector<ThinOpening> openings;
};

bool isAlongY(Side side) {
    return side == Side::West || side == Side::East;
}

double planeOf(const ThinRoom& room, Side side) {
    return planeOfSide(room.min, room.max, side);
}

Rect rectOfSide(const ThinRoom& room, Side side) {
    if (isAlongY(side))
        return {room.min.y, room.min.z, room.max.y, room.max.z};
    if (side == Side::South || side == Side::North)
        return {room.min.x, room.min.z, room.max.x, room.max.z};
    return {room.min.x, room.min.y, room.max.x, room.max.y};
}

/// The four faces between a wall at `wall` and an opening at `plane`, seen from the opening; none if both are equal.
std::vector<Face> revealsOf(Side side, const Rect& rect, double wall, double plane) {
    std::vector<Face> faces;
    if (wall == plane)
        return faces;
    const std::vector<Vec3> outer = rectOnSide(side, wall, rect), inner = rectOnSide(side, plane, rect);
    const Vec3 middle = (outer[0] + inner[2]) * 0.5;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        faces.push_back(
            planarFace(facing({outer[i], outer[j], inner[j], inner[i]}, middle), Material::StoneWall));
    }
    return faces;
}

/// A building of rooms side by side. Walls of neighbours, and walls and the exterior, are 0.1 to 5 mm apart. Trim
/// around openings begins and ends up to 3 mm from the opening's plane.
class ThinBuilder {
public:
    ThinBuilder(ModelWriter& writer, const Props& props, Random random, double leastGap)
        : writer_(writer), props_(props), random_(random), leastGap_(leastGap) {}

    /// At least `count` rooms.
    BuildingPlan build(std::uint32_t count) {
        columns_ = std::max(1u, static_cast<std::uint32_t>(std::lround(std::sqrt(count))));
        const std::uint32_t rows = (count + columns_ - 1) / columns_;
        x_ = lines(columns_);
        y_ = lines(rows);
        for (std::uint32_t j = 0; j < rows; ++j)
            for (std::uint32_t i = 0; i < columns_; ++i)
                addRoom(i, j);
        for (std::uint32_t room = 1; room < rooms_.size(); ++room) {
            const bool hasWest = room % columns_ > 0, hasSouth = room >= columns_;
            const bool west = hasWest && (!hasSouth || random_.chance(0.6));
            if (west)
                join(room - 1, room, Side::East);
            if (hasSouth && (!west || random_.chance(0.5)))
                join(room - columns_, room, Side::North);
        }
        openOutside(rows);
        for (const ThinRoom& room : rooms_)
            plan_.cells.push_back(cellOf(room));
        addExterior();
        return std::move(plan_);
    }

private:
    /// Small gaps are as frequent as large ones.
    double gap() { return leastGap_ * std::pow(kMostGap / leastGap_, random_.unit()); }

    /// The planes between rooms in one direction, and the exterior's two.
    std::vector<double> lines(std::uint32_t rooms) {
        std::vector<double> out{0.0};
        for (std::uint32_t r = 0; r < rooms; ++r)
            out.push_back(out.back() + 3.0 + 0.25 * random_.below(12));
        return out;
    }

    void addRoom(std::uint32_t i, std::uint32_t j) {
        const auto inset = [&] { return random_.chance(0.2) ? 0.0 : gap(); };
        ThinRoom room;
        room.min = {x_[i] + inset(), y_[j] + inset(), random_.chance(0.5) ? 0.0 : -gap()};
        room.max = {x_[i + 1] - inset(), y_[j + 1] - inset(), kHeight - inset()};
        if (i == 0)
            room.min.x += gap();
        if (j == 0)
            room.min.y += gap();
        if (i + 1 == columns_)
            room.max.x -= gap();
        if (j + 2 == y_.size())
            room.max.y -= gap();
        rooms_.push_back(room);
    }

    /// A door or a window in the middle part of a wall from `from` to `to`.
    Rect hole(double from, double to) {
        const double width = random_.between(0.8, 1.4), middle = random_.between(from + 0.9, to - 0.9);
        const double sill = random_.chance(0.6) ? 0.0 : random_.between(0.7, 1.1);
        return {middle - width / 2, sill, middle + width / 2, 2.05};
    }

    void join(std::uint32_t a, std::uint32_t b, Side side) {
        const Side back = side == Side::East ? Side::West : Side::South;
        const double first = planeOf(rooms_[a], side), second = planeOf(rooms_[b], back);
        const Rect along = rectOfSide(rooms_[a], side);
        const Rect rect = hole(along.u0, along.u1);
        const std::array<double, 3> planes{first, second, 0.5 * (first + second)};
        const double plane = planes[random_.below(planes.size())];
        const auto i = static_cast<std::uint16_t>(rooms_[a].openings.size());
        const auto j = static_cast<std::uint16_t>(rooms_[b].openings.size());
        rooms_[a].openings.push_back({side, rect, plane, {b, j}});
        rooms_[b].openings.push_back({back, rect, plane, {a, i}});
    }

    void openOutside(std::uint32_t rows) {
        for (std::uint32_t r = 0; r < rooms_.size(); ++r) {
            const std::uint32_t i = r % columns_, j = r / columns_;
            if (i == 0)
                openSide(r, Side::West, x_.front());
            if (i + 1 == columns_)
                openSide(r, Side::East, x_.back());
            if (j == 0)
                openSide(r, Side::South, y_.front());
            if (j + 1 == rows)
                openSide(r, Side::North, y_.back());
        }
    }

    void openSide(std::uint32_t r, Side side, double outer) {
        if (!plan_.exits.empty() && random_.chance(0.4))
            return;
        ThinRoom& room = rooms_[r];
        const double inner = planeOf(room, side);
        const Rect along = rectOfSide(room, side);
        const std::array<double, 3> planes{inner, outer, 0.5 * (inner + outer)};
        plan_.exits.push_back({r, static_cast<std::uint16_t>(room.openings.size())});
        room.openings.push_back({side,
                                 hole(along.u0, along.u1),
                                 planes[random_.below(planes.size())],
                                 {CellLink::kOutside, dat::kNoPortal}});
    }

    CellPlan cellOf(const ThinRoom& room) {
        CellPlan cell;
        cell.eye = {0.5 * (room.min.x + room.max.x), 0.5 * (room.min.y + room.max.y), 1.6};
        constexpr std::array kWalls{Material::StoneWall, Material::Brick, Material::InnerPlaster,
                                    Material::Rock};
        const Material walls = kWalls[random_.below(kWalls.size())];
        for (const Side side :
             {Side::West, Side::East, Side::South, Side::North, Side::Floor, Side::Ceiling}) {
            std::vector<Rect> holes;
            for (const ThinOpening& opening : room.openings)
                if (opening.side == side)
                    holes.push_back(opening.rect);
            for (const Rect& rect : withoutHoles(rectOfSide(room, side), holes))
                cell.faces.push_back(planarFace(rectOnSide(side, planeOf(room, side), rect),
                                                side == Side::Floor ? Material::Planks : walls));
        }
        for (const ThinOpening& opening : room.openings) {
            const double wall = planeOf(room, opening.side);
            for (Face& face : revealsOf(opening.side, opening.rect, wall, opening.plane))
                cell.faces.push_back(std::move(face));
            if (opening.link.cell == CellLink::kOutside || opening.side == Side::East ||
                opening.side == Side::North)
                addTrim(cell, opening);
        }
        for (const ThinOpening& opening : room.openings) {
            cell.faces.push_back(portalFace(rectOnSide(opening.side, opening.plane, opening.rect)));
            cell.links.push_back(opening.link);
        }
        if (random_.chance(0.5))
            cell.statics.push_back({pickProp(props_, random_),
                                    {{cell.eye.x, cell.eye.y, room.min.z}, random_.between(0.0, 90.0)}});
        return cell;
    }

    /// A frame around an opening, partly in it. In its own coordinates the opening's plane is x = 0.
    void addTrim(CellPlan& cell, const ThinOpening& opening) {
        if (random_.chance(0.35))
            return;
        constexpr double kFrom = -0.05, kTo = 0.03; // metres: over the wall, and into the opening
        const double near = random_.between(-0.003, 0.003), far = near + random_.between(0.0005, 0.003);
        const Rect& rect = opening.rect;
        const double half = 0.5 * (rect.u1 - rect.u0), high = rect.v1 - rect.v0;
        FaceMesh mesh;
        mesh.beam({near, -half + kFrom, 0.0}, {far, -half + kTo, high - kFrom}, Material::Oak);
        mesh.beam({near, half - kTo, 0.0}, {far, half - kFrom, high - kFrom}, Material::Oak);
        mesh.beam({near, -half + kTo, high - kTo}, {far, half - kTo, high - kFrom}, Material::Oak);
        const double middle = 0.5 * (rect.u0 + rect.u1);
        const Vec3 at = isAlongY(opening.side) ? Vec3(opening.plane, middle, rect.v0)
                                               : Vec3(middle, opening.plane, rect.v0);
        cell.statics.push_back({writer_.addMesh(mesh), {at, isAlongY(opening.side) ? 0.0 : 90.0}});
    }

    /// Outer walls with reveals to the openings, and a roof close above the ceilings.
    void addExterior() {
        FaceMesh& mesh = plan_.exterior;
        const Vec3 min(x_.front(), y_.front(), kThinFoot), max(x_.back(), y_.back(), kHeight + gap());
        const ThinRoom whole{min, max, {}};
        for (const Side side : {Side::West, Side::East, Side::South, Side::North, Side::Ceiling}) {
            std::vector<Rect> holes;
            for (const BuildingPlan::Exit& exit : plan_.exits) {
                const ThinOpening& opening = rooms_[exit.cell].openings[exit.portal];
                if (opening.side != side)
                    continue;
                holes.push_back(opening.rect);
                for (Face& face : revealsOf(side, opening.rect, planeOf(whole, side), opening.plane))
                    mesh.add(std::move(face));
            }
            for (const Rect& rect : withoutHoles(rectOfSide(whole, side), holes))
                mesh.add(
                    flipped(planarFace(rectOnSide(side, planeOf(whole, side), rect), Material::Plaster)));
        }
        for (const BuildingPlan::Exit& exit : plan_.exits) {
            const ThinOpening& opening = rooms_[exit.cell].openings[exit.portal];
            mesh.add(flipped(portalFace(rectOnSide(opening.side, opening.plane, opening.rect))));
        }
    }

    static constexpr double kHeight = 2.75;

    ModelWriter& writer_;
    const Props& props_;
    Random random_;
    double leastGap_;
    std::uint32_t columns_ = 1;
    std::vector<double> x_, y_;
    std::vector<ThinRoom> rooms_;
    BuildingPlan plan_;
};

} // namespace

WorldRecords buildThin(const GeneratedSpec& spec) {
    WorldRecords records;
    addGeneratedMaterials(records, spec.furnished);
    ModelWriter writer(records);
    const Props props = addProps(writer, spec.furnished);
    addRegion(writer, addGeneratedPlants(writer, spec.furnished));
    Random random(seedOf(spec));
    const Placement at{{60.0, 60.0, heightOfIndex(kThinGround) + 0.25},
                       random.chance(0.5) ? 0.0 : random.between(0.0, 360.0)};
    BuildingPlan plan = ThinBuilder(writer, props, random, leastGapOf(spec.seed)).build(spec.size);
    const std::vector<CellPlan> cells = plan.cells;
    LandblockWriter block(writer, kThinBlock, kGeneratedCells);
    const dat::RecordId first = block.add(withClosedSeams(std::move(plan)), at).front();
    WorldNotes notes;
    notes.addPlace("outside", blockToGlobal(kThinBlock, place(at, {-8.0, -8.0, 4.0})),
                   blockToGlobal(kThinBlock, place(at, cells.front().eye)), 0);
    notePlaces({"room", kThinBlock, at, first}, cells, notes);
    block.finish();
    Land(kThinBlock, 1, 1, kThinGround).addTo(records);
    records.worldFile = notes.take();
    return records;
}

} // namespace limen::worlds
