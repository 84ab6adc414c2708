#include "worlds/generate/DungeonBlock.h"

#include "worlds/generate/DungeonDoors.h"
#include "worlds/generate/Furnish.h"
#include "worlds/records/LandblockWriter.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

constexpr std::size_t kDungeonListSteps = 2;
constexpr std::size_t kMostDungeonPlaces = 64, kMostDoors = 400;

/// Replacements for the surfaces of stored shapes: floor, walls, ceiling. The first row is the stored one.
constexpr std::array<std::array<Material, 3>, 5> kThemes{
    {{Material::Flagstones, Material::StoneWall, Material::Brick},
     {Material::Planks, Material::InnerPlaster, Material::Beam},
     {Material::Rock, Material::Rock, Material::Rock},
     {Material::Flagstones, Material::Brick, Material::StoneWall},
     {Material::Brick, Material::Plaster, Material::OldPlanks}}};

std::vector<std::uint16_t> dressed(const std::vector<std::uint16_t>& surfaces, std::uint32_t theme) {
    std::vector<std::uint16_t> out;
    for (const std::uint16_t surface : surfaces) {
        std::uint16_t replaced = surface;
        for (std::size_t k = 0; k < 3; ++k)
            if (surface == (surfaceId(kThemes[0][k]) & 0xFFFF))
                replaced = static_cast<std::uint16_t>(surfaceId(kThemes[theme][k]) & 0xFFFF);
        out.push_back(replaced);
    }
    return out;
}

/// The index in a room's list of the first opening of a way.
std::uint16_t firstOpening(const LatticeRoom& room, std::size_t way) {
    std::uint16_t index = 0;
    for (std::size_t w = 0; w < way; ++w) {
        index = static_cast<std::uint16_t>(
            index + (w >= 4 ? (room.doors[w] == Door::None ? 0 : 1) : openingsOf(room.doors[w])));
    }
    return index;
}

std::uint16_t openingCount(const LatticeRoom& room, std::size_t way) {
    return way >= 4 ? (room.doors[way] == Door::None ? 0 : 1) : openingsOf(room.doors[way]);
}

class BlockOfRooms {
public:
    BlockOfRooms(const DungeonTools& tools, dat::BlockCoord coord, Random random)
        : writer_(tools.writer), shapes_(tools.shapes), props_(tools.props), leaves_(tools.leaves),
          coord_(coord), random_(random) {}

    void write(const DungeonLayout& layout, WorldNotes& notes) {
        layout_ = &layout;
        cells_.resize(layout.cells);
        for (const LatticeRoom& room : layout.rooms)
            writeRoom(room);
        for (const Passage& passage : layout.passages)
            if (passage.cell != kNothing)
                writePassage(passage);
        for (const LatticeRoom& room : layout.rooms)
            furnish(room, notes);
        notePlaces(notes);
        finish();
    }

private:
    [[nodiscard]] dat::RecordId idOf(std::uint32_t cell) const {
        return dat::blockWord(coord_) | (dat::kFirstCell + cell);
    }

    void begin(std::uint32_t cell, const StoredShape& shape, const Placement& at) {
        cells_[cell].shape = shape;
        cells_[cell].shape.surfaces = dressed(shape.surfaces, random_.below(kThemes.size()));
        cells_[cell].at = at;
    }

    void addPortal(std::uint32_t cell, std::uint32_t other, std::uint16_t otherPortal) {
        cells_[cell].links.push_back({other, otherPortal});
    }

    void writeRoom(const LatticeRoom& room) {
        begin(room.cell, shapes_.of(room), {room.floor, 0.0});
        for (std::size_t way = 0; way < kWays; ++way) {
            const std::uint16_t count = openingCount(room, way);
            for (std::uint16_t k = 0; k < count; ++k) {
                const Passage& passage = layout_->passages[room.passages[way]];
                const bool outOf = way % 2 == 1;
                if (passage.cell == kNothing) {
                    const LatticeRoom& next = layout_->rooms[outOf ? passage.to : passage.from];
                    addPortal(room.cell, next.cell,
                              static_cast<std::uint16_t>(firstOpening(next, opposite(way)) + k));
                } else {
                    addPortal(room.cell, passage.cell, static_cast<std::uint16_t>(outOf ? k : count + k));
                }
            }
        }
    }

    void writePassage(const Passage& passage) {
        const LatticeRoom& from = layout_->rooms[passage.from];
        const auto way = static_cast<std::size_t>(passage.way);
        const double rise = passage.to == kNothing || passage.way == Way::Up
                                ? 0.0
                                : layout_->rooms[passage.to].floor.z - from.floor.z;
        const Placement placement = passagePlacement(passage, from);
        begin(passage.cell, shapes_.of(passage, rise), placement);
        if (props_.furnished && passage.way != Way::Up)
            hangTorches(passage, rise, placement);
        const std::uint16_t count = openingCount(from, way);
        for (std::uint16_t k = 0; k < count; ++k)
            addPortal(passage.cell, from.cell, static_cast<std::uint16_t>(firstOpening(from, way) + k));
        if (passage.to == kNothing)
            return;
        const LatticeRoom& to = layout_->rooms[passage.to];
        for (std::uint16_t k = 0; k < count; ++k)
            addPortal(passage.cell, to.cell, static_cast<std::uint16_t>(firstOpening(to, opposite(way)) + k));
    }

    void hangTorches(const Passage& passage, double rise, const Placement& placement) {
        std::vector<Furnishing> torches;
        furnishPassage(torches, passage, rise, props_);
        for (const Furnishing& torch : torches)
            addStatic(passage.cell, torch.model,
                      {place(placement, torch.at.origin), placement.turn + torch.at.turn});
    }

    void addStatic(std::uint32_t cell, dat::RecordId model, const Placement& at) {
        cells_[cell].statics.push_back({model, at});
    }

    void furnish(const LatticeRoom& room, WorldNotes& notes) {
        if (props_.furnished) {
            std::vector<Furnishing> furniture;
            furnishRoom(furniture, room, props_, apartFrom(random_));
            for (const Furnishing& piece : furniture)
                addStatic(room.cell, piece.model, {room.floor + piece.at.origin, piece.at.turn});
        }
        const bool lamp = room.form == Form::Box && random_.chance(0.5);
        if (lamp && !props_.furnished)
            addStatic(room.cell, props_.lamp, {room.floor + Vec3(-2.0, 2.0, 0.0), 0.0});
        if (random_.chance(0.3)) {
            // Clear of the hatch in the middle; in a small room a prop may intersect a wall.
            const double x = random_.between(1.6, 2.6) * (random_.chance(0.5) ? 1.0 : -1.0);
            const double y = random_.between(1.6, 2.6) * (random_.chance(0.5) ? 1.0 : -1.0);
            if (room.form == Form::Box) {
                addStatic(room.cell, pickProp(props_, random_),
                          {room.floor + Vec3(x, y, 0.0), random_.between(0.0, 360.0)});
            }
        }
        for (const std::size_t way : {std::size_t{1}, std::size_t{3}})
            for (std::uint16_t k = 0; k < openingCount(room, way); ++k)
                furnishOpening(room, way, k, notes);
    }

    /// At random: a rod through the opening, a pane in front of it, or a door in it.
    void furnishOpening(const LatticeRoom& room, std::size_t way, std::uint16_t k, WorldNotes& notes) {
        const Door door = room.doors[way];
        const DoorExtent extent = extentOf(door, k);
        const RoomSize& size = kRoomSizes[room.size];
        const double turn = way == 1 ? 0.0 : 90.0;
        const Placement wall{room.floor + (way == 1 ? Vec3(size.halfX, 0, 0) : Vec3(0, size.halfY, 0)), turn};
        const double middle = 0.5 * (extent.from + extent.to);
        const double pick = random_.unit();
        if (pick < 0.05) {
            addStatic(room.cell, props_.rod, {place(wall, {0.0, middle, 1.1}), turn});
        } else if (pick < 0.08) {
            addStatic(room.cell, props_.pane, {place(wall, {-0.125, middle, 1.2}), turn + 90.0});
        } else if (pick < 0.2 && extent.rectangular && notes.doorCount() < kMostDoors) {
            addDoor({idOf(room.cell), static_cast<std::uint16_t>(firstOpening(room, way) + k)}, door, extent,
                    wall, notes);
        }
    }

    void addDoor(WorldNotes::Door door, Door kind, const DoorExtent& extent, const Placement& wall,
                 WorldNotes& notes) {
        // The leaf's +x is -y of the wall's frame: the leaf faces along the passage.
        const double yaw = 90.0 - wall.turn;
        const auto hinge = [&](double across) {
            return blockToGlobal(coord_, place(wall, {0.0, across, 0.0}));
        };
        door.opaque = !random_.chance(0.2);
        door.open = random_.chance(0.4) ? 0.0 : random_.chance(0.5) ? 1.0 : 0.375;
        std::vector<WorldNotes::Leaf> leaves;
        if (kind == Door::Wide && door.opaque) {
            leaves.push_back({leaves_.half, hinge(extent.to), yaw, 95.0});
            leaves.push_back({leaves_.half, hinge(extent.from), yaw - 180.0, -95.0});
        } else if (kind == Door::Wide) {
            leaves.push_back({leaves_.glass, hinge(extent.to), yaw, 0.0});
        } else {
            leaves.push_back({leaves_.narrow, hinge(extent.to), yaw, 100.0});
            door.opaque = true;
        }
        notes.addDoor(door, leaves);
    }

    void notePlaces(WorldNotes& notes) const {
        const std::size_t count = layout_->rooms.size();
        const std::size_t step = std::max<std::size_t>(1, count / kMostDungeonPlaces);
        for (std::size_t r = 0; r < count; r += step) {
            const LatticeRoom& room = layout_->rooms[r];
            const auto way = static_cast<std::size_t>(std::find_if(room.doors.begin(), room.doors.begin() + 4,
                                                                   [](Door d) { return d != Door::None; }) -
                                                      room.doors.begin());
            const std::array<Vec3, 5> ahead{Vec3(-1, 0.02, -0.05), Vec3(1, -0.03, -0.05),
                                            Vec3(0.02, -1, -0.05), Vec3(0.02, 1, -0.05),
                                            Vec3(0.6, 0.6, -0.3)};
            const Vec3 eye = blockToGlobal(coord_, room.floor + eyePoint(room.form));
            notes.addPlace(fmt::format("room.{}", notes.placeCount()), eye, eye + ahead[way],
                           idOf(room.cell));
        }
    }

    void finish() {
        Neighbours neighbours;
        for (const PlacedCell& cell : cells_) {
            std::vector<std::uint32_t>& next = neighbours.emplace_back();
            for (const CellLink& link : cell.links)
                next.push_back(link.cell);
        }
        for (std::uint32_t c = 0; c < cells_.size(); ++c)
            cells_[c].visible = cellsWithin(neighbours, c, kDungeonListSteps);
        LandblockWriter block(writer_, coord_, kGeneratedCells);
        block.addCells(cells_);
        block.finish();
        dat::LandBlock land;
        land.id = dat::landBlockId(coord_);
        land.hasObjects = 1;
        writer_.records().landBlocks.push_back(land);
    }

    ModelWriter& writer_;
    DungeonShapes& shapes_;
    const Props& props_;
    const DungeonLeaves& leaves_;
    dat::BlockCoord coord_;
    Random random_;
    const DungeonLayout* layout_ = nullptr;
    std::vector<PlacedCell> cells_; ///< by index of the layout
};

} // namespace

DungeonLeaves addDungeonLeaves(ModelWriter& writer, bool furnished) {
    return {addLeaf(writer, {1.25, 2.25, true, furnished}), addLeaf(writer, {1.0, 2.5, true, furnished}),
            addLeaf(writer, {2.0, 2.5, false, furnished})};
}

void writeDungeonBlock(const DungeonTools& tools, dat::BlockCoord coord, const DungeonLayout& layout,
                       Random random, WorldNotes& notes) {
    BlockOfRooms(tools, coord, random).write(layout, notes);
}

} // namespace limen::worlds
