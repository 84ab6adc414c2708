#include "world/Solids.h"

#include "core/Assert.h"
#include "world/LeafPose.h"
#include "world/Loader.h"
#include "world/Membership.h"
#include "world/Nearby.h"
#include "world/OpeningParts.h"
#include "world/block/BlockReader.h"
#include "world/block/CellReader.h"
#include "world/records/PolygonSource.h"
#include "world/records/Pose.h"

#include <algorithm>
#include <numbers>

namespace limen::world {
namespace {

constexpr int kGroundCuts = 8; ///< squares along a landcell's side
constexpr double kLeastArea =
    1e-8; ///< twice the area, square metres; smaller triangles have no usable normal

Vec3 placedAt(const Placement& placement, const Vec3& point) {
    return placement.origin + placement.linear * point;
}

Placement within(const Placement& outer, const Mat3& linear, const Vec3& origin) {
    return {outer.linear * linear, placedAt(outer, origin)};
}

Mat3 scaling(const Vec3& scale) {
    return {Vec3(scale.x, 0.0, 0.0), Vec3(0.0, scale.y, 0.0), Vec3(0.0, 0.0, scale.z)};
}

/// Adds the solids of one block after another.
class SolidsReader {
public:
    SolidsReader(const dat::Archive& archive, const World& world, const dat::Region* region, Solids& out)
        : archive_(archive), world_(world), records_(archive),
          models_(records_, {.detail = std::numeric_limits<double>::infinity()}),
          reader_(records_, models_, region, true), out_(out) {
        for (InstanceIndex i = 0; i < world.instances.size(); ++i)
            byObject_.try_emplace(world.instances[i].object, i);
    }

    void read(const Block& block) {
        offset_ = block.origin() - out_.origin;
        const SpaceIndex outside[] = {kOutside};
        if (block.hasTerrain)
            add(InstanceKind::Terrain, outside, [&] { addGround(block); });
        if (const std::optional<BlockContent> content = reader_.read(block.coord)) {
            for (const CellContent& cell : content->cells)
                addCell(cell.id);
            for (const PlacedModel& object : content->objects)
                addObject(object);
        }
        const Result<dat::LandBlockInfo> info =
            archive_.load<dat::LandBlockInfo>(dat::landBlockInfoId(block.coord));
        for (std::size_t i = 0; info && i < info->buildings.size(); ++i) {
            const Pose pose = poseOf(info->buildings[i].frame);
            add(InstanceKind::Exterior, outside, [&] {
                addModel(info->buildings[i].model, {glm::mat3_cast(pose.orientation), pose.origin});
            });
        }
    }

    /// The objects of a world database on the blocks that were read. Doors in their openings have leaves instead.
    void addPlaced(std::span<const dat::BlockCoord> blocks) {
        const Membership membership(world_);
        offset_ = -out_.origin;
        for (const PlacedObject& placed : world_.placed) {
            const bool isNear =
                std::find(blocks.begin(), blocks.end(), blockAt(placed.origin)) != blocks.end();
            if (!placed.stopsBodies || placed.isHung || !isNear)
                continue;
            std::vector<SpaceIndex> members;
            const double radius = std::max(models_.model(placed.model).bounds.radius, 0.0) +
                                  glm::length(models_.model(placed.model).bounds.centre);
            membership.reach(placed.space, {placed.origin, radius * placed.scale}, {}, members);
            add(InstanceKind::Static, members, [&] {
                addModel(placed.model, {glm::mat3_cast(placed.orientation) * placed.scale, placed.origin});
            });
        }
    }

    /// The fillings, which block on both sides of their portals, and the leaves.
    void addDoors() {
        const Membership membership(world_);
        for (std::uint32_t d = 0; d < world_.doors.size(); ++d) {
            const Door& door = world_.doors[d];
            if (door.portal == kNone)
                continue; // a thing that opens: the solid of its Setup stays as it is
            const Portal& portal = openingOf(world_, door.portal);
            if (portal.destination != kNone && portal.vertexCount >= 3)
                addFilling(d, portal);
            for (std::uint32_t l = door.firstLeaf; l < door.firstLeaf + door.leafCount; ++l)
                addLeaf(d, l, membership);
        }
    }

private:
    /// Adds a solid of the triangles that `fill` adds, if there are any.
    template <class Fill>
    void add(InstanceKind kind, std::span<const SpaceIndex> members, Fill&& fill) {
        LIMEN_ASSERT(!members.empty(), "a solid blocks in some space");
        const auto first = static_cast<std::uint32_t>(out_.corners.size() / 3);
        fill();
        LIMEN_ASSERT(out_.corners.size() % 3 == 0, "corners come in threes");
        const auto count = static_cast<std::uint32_t>(out_.corners.size() / 3) - first;
        if (count == 0)
            return;
        out_.solids.push_back({kind, first, count, static_cast<std::uint32_t>(out_.members.size()),
                               static_cast<std::uint32_t>(members.size()), kNone, kNone});
        out_.members.insert(out_.members.end(), members.begin(), members.end());
    }

    void addFilling(std::uint32_t door, const Portal& portal) {
        const SpaceIndex sides[] = {portal.space, portal.destination};
        const std::size_t before = out_.solids.size();
        offset_ = -out_.origin;
        add(InstanceKind::Filling, sides, [&] { addFan(polygonOf(world_, portal), Placement()); });
        for (std::size_t i = before; i < out_.solids.size(); ++i)
            out_.solids[i].door = door;
    }

    /// A leaf blocks in all spaces that it can reach at any angle.
    void addLeaf(std::uint32_t door, std::uint32_t index, const Membership& membership) {
        const Portal& portal = world_.portals[world_.doors[door].portal];
        const Leaf& leaf = world_.leaves[index];
        std::vector<SpaceIndex> members{portal.space};
        if (portal.destination != kNone && portal.destination != portal.space)
            members.push_back(portal.destination);
        const Vec3 centre = leaf.body.bounds.centre;
        const Vec3 axis(0.0, 0.0, centre.z);
        const Sphere around{leaf.hinge + axis, leaf.body.bounds.radius + glm::length(centre - axis)};
        membership.extend(leaf.keyCount == 0 ? around : leafReach(world_, leaf), {}, members);
        const std::size_t before = out_.solids.size();
        offset_ = Vec3(0.0);
        add(InstanceKind::Filling, members, [&] { addModel(leaf.model, {scaling(leaf.scale), Vec3(0.0)}); });
        for (std::size_t i = before; i < out_.solids.size(); ++i) {
            out_.solids[i].door = door;
            out_.solids[i].leaf = index;
        }
    }

    void addFan(std::span<const Vec3> points, const Placement& placement) {
        for (std::size_t i = 2; i < points.size(); ++i) {
            const std::array triangle{placedAt(placement, points[0]), placedAt(placement, points[i - 1]),
                                      placedAt(placement, points[i])};
            const Vec3 across = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
            for (const Vec3& corner : triangle)
                if (glm::length(across) > kLeastArea)
                    out_.corners.push_back(offset_ + corner);
        }
    }

    void addPolygons(const dat::VertexArray& vertices, const dat::PolygonList& polygons,
                     const Placement& placement) {
        for (const std::vector<Vec3>& outline : readOutlines(vertices, polygons))
            addFan(outline, placement);
    }

    void addGround(const Block& block) {
        constexpr int kSteps = 8 * kGroundCuts;
        constexpr double kStep = kBlockSize / kSteps;
        const auto at = [&](int x, int y) {
            return Vec3(x * kStep, y * kStep, groundAt(block.coord, block.heights, x * kStep, y * kStep).z);
        };
        for (int x = 0; x < kSteps; ++x) {
            for (int y = 0; y < kSteps; ++y) {
                const Vec3 sw = at(x, y), se = at(x + 1, y), ne = at(x + 1, y + 1), nw = at(x, y + 1);
                const bool cut = splitsSouthWestNorthEast(block.coord, x / kGroundCuts, y / kGroundCuts);
                addFan(cut ? std::array{sw, se, ne, nw} : std::array{se, ne, nw, sw}, Placement());
            }
        }
    }

    void addCell(dat::RecordId id) {
        const SpaceIndex space[] = {findCell(world_, id)};
        const Result<dat::EnvCell> cell = archive_.load<dat::EnvCell>(id);
        const dat::CellStruct* shape = cell ? findShape(*cell, records_) : nullptr;
        if (space[0] == kNone || shape == nullptr)
            return;
        const Pose pose = poseOf(cell->position);
        add(InstanceKind::Shell, space, [&] {
            addPolygons(shape->vertexArray, shape->physicsPolygons,
                        {glm::mat3_cast(pose.orientation), pose.origin});
        });
    }

    void addObject(const PlacedModel& object) {
        const auto found = byObject_.find(object.object);
        if (found == byObject_.end())
            return;
        const Instance& instance = world_.instances[found->second];
        std::span<const SpaceIndex> members =
            std::span(world_.members).subspan(instance.firstMember, instance.memberCount);
        if (members.empty())
            members = {&instance.placedIn, 1};
        add(object.kind, members, [&] {
            addModel(object.model, {glm::mat3_cast(object.orientation) * object.scale, object.origin});
        });
    }

    void addModel(dat::RecordId model, const Placement& placement) {
        if (isGfxObj(model)) {
            addGfxObj(model, placement);
            return;
        }
        const dat::Setup* setup = records_.setup(model);
        if (setup == nullptr)
            return;
        // Like the original client: the shapes of the parts, else cylinders, else spheres
        // (docs/formats/geometry.md#setup).
        if ((setup->flags & dat::Setup::kPhysicsBsp) != 0)
            for (const ModelPart& part : models_.model(model).parts)
                addGfxObj(part.gfxObj, within(placement, part.linear, part.origin));
        else if (!setup->cylSpheres.empty())
            for (const dat::CylSphere& c : setup->cylSpheres)
                addRound(within(placement, Mat3(1.0), Vec3(c.low)), c.radius, 0.0, c.height);
        else
            for (const dat::SphereF& s : setup->spheres)
                addRound(within(placement, Mat3(1.0), Vec3(s.centre)), s.radius, s.radius, 0.0);
    }

    void addGfxObj(dat::RecordId id, const Placement& placement) {
        const dat::GfxObj* record = records_.gfxObj(id);
        if (record != nullptr && (record->flags & dat::GfxObj::kPhysics) != 0)
            addPolygons(record->vertexArray, record->physicsPolygons, placement);
    }

    /// A polyhedron for a cylinder that stands on the placement's origin or, with `bulge` > 0, for a sphere
    /// around it.
    void addRound(const Placement& placement, double radius, double bulge, double height) {
        constexpr int kSides = 12, kRings = 6;
        if (!(radius > 0.0) || !std::isfinite(radius) || !std::isfinite(height))
            return;
        std::vector<std::pair<double, double>> rings; // (radius, height), the lowest first
        if (bulge > 0.0) {
            for (int i = 0; i <= kRings; ++i) {
                const double angle = std::numbers::pi * (static_cast<double>(i) / kRings - 0.5);
                rings.emplace_back(radius * std::cos(angle), bulge * std::sin(angle));
            }
        } else {
            rings = {{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}};
        }
        const auto at = [&](const std::pair<double, double>& ring, int side) {
            const double angle = 2.0 * std::numbers::pi * side / kSides;
            return Vec3(ring.first * std::cos(angle), ring.first * std::sin(angle), ring.second);
        };
        for (std::size_t i = 1; i < rings.size(); ++i) {
            for (int side = 0; side < kSides; ++side) {
                addFan(std::array{at(rings[i - 1], side), at(rings[i - 1], side + 1), at(rings[i], side + 1),
                                  at(rings[i], side)},
                       placement);
            }
        }
    }

    const dat::Archive& archive_;
    const World& world_;
    Records records_;
    Models models_;
    BlockReader reader_;
    std::unordered_map<std::uint64_t, InstanceIndex> byObject_;
    Solids& out_;
    Vec3 offset_{0.0}; ///< added to corners: from the space of the current shape to that of Solids::corners
};

} // namespace

Result<Solids> loadSolids(const dat::Archive& archive, const World& world, dat::BlockCoord centre,
                          int radius) {
    const std::vector<dat::BlockCoord> blocks = blocksAround(centre, radius);
    const Result<std::unique_ptr<dat::Region>> region = loadRegion(archive, blocks);
    if (!region)
        return Failure(region.error());
    Solids solids;
    solids.radius = radius;
    solids.centre = centre;
    solids.origin = {centre.x * kBlockSize, centre.y * kBlockSize, 0.0};
    SolidsReader reader(archive, world, region->get(), solids);
    LIMEN_ASSERT(radius >= 0, "a number of blocks");
    for (const dat::BlockCoord coord : blocks)
        if (const Block* block = findBlock(world, coord))
            reader.read(*block);
    reader.addPlaced(blocks);
    reader.addDoors();
    return solids;
}

} // namespace limen::world
