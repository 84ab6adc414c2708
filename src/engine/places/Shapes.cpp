#include "engine/places/Shapes.h"

#include "geometry/ConvexPolygon.h"
#include "world/Ground.h"
#include "world/Lookup.h"
#include "world/block/CellReader.h"
#include "world/records/PolygonSource.h"
#include "world/terrain/Scenery.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limen::engine {
namespace {

constexpr double kBodyHeight = 1.6;      // metres, of the lowest door
constexpr double kBodyWidth = 0.6;       // metres, of the narrowest door
constexpr double kStandingEye = 1.7;     // metres above the feet
constexpr double kHeadroom = 0.15;       // metres between an eye and the top of a door
constexpr double kUpright = 0.5;         // largest vertical part of a door's normal
constexpr double kOneSide = 0.01;        // metres, as world/block/CellPortals.cpp
constexpr std::size_t kMostShapes = 800; // environments kept; the game's files have 772

std::vector<Vec3> cornersIn(const world::SourcePolygon& polygon, const Mat3& linear, const Vec3& origin) {
    std::vector<Vec3> corners;
    for (const world::SourcePolygon::Corner& corner : polygon.corners)
        corners.push_back(origin + linear * corner.position);
    return corners;
}

/// +1 if all points are in front of the plane, -1 if behind, 0 if both or neither.
int sideOfAll(const Vec3& normal, const Vec3& on, const std::vector<std::vector<Vec3>>& walls) {
    double least = 0.0, most = 0.0;
    for (const std::vector<Vec3>& wall : walls) {
        for (const Vec3& corner : wall) {
            least = std::min(least, glm::dot(corner - on, normal));
            most = std::max(most, glm::dot(corner - on, normal));
        }
    }
    if (least >= -kOneSide && most > kOneSide)
        return 1;
    return most <= kOneSide && least < -kOneSide ? -1 : 0;
}

/// Fills in the values that follow from the outline.
void measure(Opening& opening, bool isFlagged, const std::vector<std::vector<Vec3>>& walls) {
    Vec3 normal = newellNormal(opening.outline);
    const double area = glm::length(normal);
    if (!(area > 1e-6))
        return;
    normal /= area;
    for (const Vec3& corner : opening.outline)
        opening.middle += corner / static_cast<double>(opening.outline.size());
    const int side = sideOfAll(normal, opening.middle, walls);
    opening.inward = (side != 0 ? side > 0 : isFlagged) ? normal : -normal;
    double top = -1e300;
    opening.sill = 1e300;
    for (const Vec3& a : opening.outline) {
        opening.sill = std::min(opening.sill, a.z);
        top = std::max(top, a.z);
        for (const Vec3& b : opening.outline)
            opening.width = std::max(opening.width, std::hypot(a.x - b.x, a.y - b.y));
    }
    opening.height = top - opening.sill;
}

} // namespace

bool Opening::isDoor() const {
    return std::abs(inward.z) < kUpright && inward != Vec3(0.0) && height >= kBodyHeight &&
           width >= kBodyWidth &&
           containsProjection(outline, glm::normalize(newellNormal(outline)), eye(), 0.0);
}

Vec3 Opening::eye() const {
    const Vec3 at(middle.x, middle.y, sill + std::min(kStandingEye, height - kHeadroom));
    const Vec3 level(inward.x, inward.y, 0.0);
    const double flat = glm::dot(level, level);
    return flat > 0.0 ? at - level * (glm::dot(at - middle, inward) / flat)
                      : at; // in the opening's plane, which may lean
}

Vec3 originOf(dat::BlockCoord block) {
    return Vec3(block.x, block.y, 0.0) * world::kBlockSize;
}

Shapes::Shapes(const dat::Archive& archive) : archive_(archive), records_(archive) {
    if (Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId))
        region_ = std::make_unique<dat::Region>(std::move(*region));
}

void Shapes::forget() {
    cells_.clear();
    blocks_.clear();
    heights_.clear();
    records_.forgetEnvironments(kMostShapes);
}

const std::optional<Shapes::Heights>& Shapes::heights(dat::BlockCoord coord) {
    const auto [entry, isNew] = heights_.try_emplace(dat::blockWord(coord));
    if (isNew && region_ != nullptr)
        if (const Result<dat::LandBlock> land = archive_.load<dat::LandBlock>(dat::landBlockId(coord)))
            entry->second = world::landOf(world::groundOf(*land, *region_)).heights;
    return entry->second;
}

double Shapes::ground(double x, double y) {
    const double end = world::kMapSize * world::kBlockSize;
    if (!(x >= 0.0 && y >= 0.0 && x < end && y < end))
        return std::numeric_limits<double>::quiet_NaN();
    const dat::BlockCoord coord = world::blockAt({x, y, 0.0});
    const std::optional<Heights>& known = heights(coord);
    const Vec3 origin = originOf(coord);
    return known ? world::groundAt(coord, *known, x - origin.x, y - origin.y).z
                 : std::numeric_limits<double>::quiet_NaN();
}

const CellShape* Shapes::cell(dat::RecordId id) {
    const auto [entry, isNew] = cells_.try_emplace(id);
    if (isNew)
        entry->second = readCell(id);
    return entry->second ? &*entry->second : nullptr;
}

const BlockShape& Shapes::block(dat::BlockCoord coord) {
    const auto [entry, isNew] = blocks_.try_emplace(dat::blockWord(coord));
    if (isNew)
        entry->second = readBlock(coord);
    return entry->second;
}

void Shapes::addGfxObj(dat::RecordId id, const Mat3& linear, const Vec3& origin, std::vector<Triangle>& out) {
    const dat::GfxObj* model = records_.gfxObj(id);
    if (model == nullptr)
        return;
    std::set<std::uint16_t> portals;
    for (const world::PortalPolygonRef& ref : world::portalRefs(*model, world::kAnyPortalCount))
        portals.insert(ref.polygonId);
    std::vector<world::Finding> ignored;
    for (const world::SourcePolygon& polygon : world::readPolygons(
             model->vertexArray, model->polygons,
             world::drawnSlots(model->surfaces, world::MeshOwner::Thing, records_), portals, id, ignored))
        if (polygon.isDrawn())
            addFan(cornersIn(polygon, linear, origin), out);
    for (std::vector<Vec3>& outline : world::readOutlines(model->vertexArray, model->physicsPolygons)) {
        for (Vec3& corner : outline)
            corner = origin + linear * corner;
        addFan(outline, out);
    }
}

void Shapes::addModel(dat::RecordId model, const world::Pose& pose, double scale,
                      std::vector<Triangle>& out) {
    const Mat3 turn = glm::mat3_cast(pose.orientation) * scale;
    if (world::isGfxObj(model))
        return addGfxObj(model, turn, pose.origin, out);
    const dat::Setup* setup = world::isSetup(model) ? records_.setup(model) : nullptr;
    for (std::size_t i = 0; setup != nullptr && i < setup->parts.size(); ++i) {
        const world::Pose part = world::restOf(*setup, i);
        Mat3 linear = glm::mat3_cast(part.orientation);
        if (i < setup->scales.size())
            for (int axis = 0; axis < 3; ++axis)
                linear[axis] *= static_cast<double>(setup->scales[i][axis]);
        addGfxObj(setup->parts[i], turn * linear, pose.origin + turn * part.origin, out);
    }
}

std::optional<CellShape> Shapes::readCell(dat::RecordId id) {
    const Result<dat::EnvCell> record = archive_.load<dat::EnvCell>(id);
    const dat::CellStruct* shape = record ? world::findShape(*record, records_) : nullptr;
    if (shape == nullptr)
        return {};
    world::Pose pose = world::poseOf(record->position);
    const Vec3 block = originOf(dat::blockOf(id));
    const Mat3 linear = glm::mat3_cast(pose.orientation);
    std::set<std::uint16_t> portals(shape->portalPolygons.begin(), shape->portalPolygons.end());
    for (const dat::CellPortal& portal : record->portals)
        portals.insert(portal.polygonId);
    CellShape cell;
    cell.id = id;
    std::vector<world::Finding> ignored;
    std::map<std::uint16_t, std::vector<Vec3>> outlines;
    std::vector<Triangle> triangles;
    for (const world::SourcePolygon& polygon : world::readPolygons(
             shape->vertexArray, shape->polygons,
             world::drawnSlots(world::surfaceIds(*record), world::MeshOwner::Structure, records_), portals,
             id, ignored)) {
        std::vector<Vec3> corners = cornersIn(polygon, linear, block + pose.origin);
        if (polygon.isPortal)
            outlines.emplace(polygon.id, corners);
        if (!polygon.isDrawn())
            continue;
        if (polygon.frontSlot < 0)
            std::reverse(corners.begin(), corners.end());
        addFan(corners, triangles);
        if (!polygon.isPortal) // its picture may face the next cell
            cell.walls.push_back(std::move(corners));
    }
    cell.solids.add(std::move(triangles));
    for (const dat::CellPortal& portal : record->portals) {
        Opening opening;
        opening.otherCell =
            portal.otherCellId == dat::kOutdoors ? 0 : (id & 0xFFFF0000u) | portal.otherCellId;
        opening.otherPortal = portal.otherPortalId;
        if (const auto found = outlines.find(portal.polygonId); found != outlines.end()) {
            opening.outline = found->second;
            measure(opening, (portal.flags & dat::CellPortal::kPortalSide) != 0, cell.walls);
        }
        cell.openings.push_back(std::move(opening));
    }
    for (const dat::Stab& stab : record->statics) {
        std::vector<Triangle> object;
        world::Pose placed = world::poseOf(stab.frame);
        placed.origin += block;
        addModel(stab.model, placed, 1.0, object);
        cell.solids.add(std::move(object));
    }
    return cell;
}

void Shapes::addScenery(BlockShape& block) {
    const Result<dat::LandBlock> land = archive_.load<dat::LandBlock>(dat::landBlockId(block.coord));
    if (!land || region_ == nullptr)
        return;
    std::set<int> built;
    for (const BuildingShape& building : block.buildings) {
        const Vec3 at(building.record.frame.origin);
        const auto landcell = [](double v) {
            return std::clamp(static_cast<int>(v / world::kLandcellSize), 0, 7);
        };
        if (isFinite(at))
            built.insert(landcell(at.x) * 8 + landcell(at.y));
    }
    for (const world::SceneryObject& object :
         world::growScenery(world::groundOf(*land, *region_), *region_, built, records_)) {
        std::vector<Triangle> triangles;
        addModel(object.model, {object.orientation, originOf(block.coord) + object.origin}, object.scale,
                 triangles);
        block.solids.add(std::move(triangles));
    }
}

BlockShape Shapes::readBlock(dat::BlockCoord coord) {
    BlockShape block;
    block.coord = coord;
    const Vec3 origin = originOf(coord);
    const Result<dat::LandBlockInfo> info = archive_.load<dat::LandBlockInfo>(dat::landBlockInfoId(coord));
    if (info) {
        for (const dat::Building& building : info->buildings) {
            std::vector<Triangle> triangles;
            world::Pose pose = world::poseOf(building.frame);
            pose.origin += origin;
            addModel(building.model, pose, 1.0, triangles);
            const bool hasExterior = !triangles.empty();
            block.solids.add(std::move(triangles));
            BuildingShape shape{building, pose.origin, {}};
            if (hasExterior) {
                shape.bounds = block.solids.groups().back().bounds;
                shape.middle = (shape.bounds.min + shape.bounds.max) * 0.5;
            }
            block.buildings.push_back(std::move(shape));
        }
        for (const dat::Stab& stab : info->objects) {
            std::vector<Triangle> triangles;
            world::Pose pose = world::poseOf(stab.frame);
            pose.origin += origin;
            addModel(stab.model, pose, 1.0, triangles);
            block.solids.add(std::move(triangles));
        }
    }
    addScenery(block);
    return block;
}

} // namespace limen::engine
