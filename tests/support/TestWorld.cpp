#include "support/TestWorld.h"

#include "geometry/ConvexPolygon.h"
#include "support/MeshRecords.h"

#include <algorithm>

namespace limen::test {
namespace {

Vec3 rotated(const Quat& q, const Vec3& p) {
    return q * p;
}

Vec3 toLocal(const dat::Frame& frame, const Vec3& p) {
    return rotated(glm::conjugate(glm::normalize(Quat(frame.orientation))), p - Vec3(frame.origin));
}

std::vector<Vec3> toLocal(const dat::Frame& frame, std::span<const Vec3> points) {
    std::vector<Vec3> out;
    for (const Vec3& p : points)
        out.push_back(toLocal(frame, p));
    return out;
}

Vec3 centreOf(const Walls& walls) {
    Vec3 sum(0.0);
    double count = 0.0;
    for (const Wall& wall : walls) {
        for (const Vec3& p : wall.points) {
            sum += p;
            count += 1.0;
        }
    }
    return sum / std::max(count, 1.0);
}

bool known(std::span<const Plane> planes, const Plane& plane) {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& p) {
        return glm::length(p.n - plane.n) < 1e-6 && std::abs(p.d - plane.d) < 1e-4;
    });
}

} // namespace

dat::Frame frameAt(const Vec3& origin, double turnDegrees) {
    const double half = turnDegrees * 3.14159265358979323846 / 360.0;
    return {Vec3f(origin),
            Quatf(static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half)))};
}

TestWorld::TestWorld(dat::BlockCoord home)
    : home_(home), portalFile_(dat::FileTraits::portal()), cellFile_(dat::FileTraits::cell()) {
    makeRegion();
}

TestWorld::Cell TestWorld::addCell(Walls walls, const CellOptions& options) {
    CellData cell;
    cell.block = options.block.value_or(home_);
    std::uint32_t& count = cellCounts_[dat::blockWord(cell.block)];
    cell.record.id = dat::blockWord(cell.block) | (dat::kFirstCell + count++);
    cell.record.flags = options.seenOutside ? dat::EnvCell::kSeenOutside : 0;
    cell.record.position = options.frame;
    cell.walls = std::move(walls);
    cell.bsp = options.bsp;
    cell.tree = options.tree;
    cells_.push_back(std::move(cell));
    return cells_.size() - 1;
}

TestWorld::Portal TestWorld::addPortal(Cell handle, std::vector<Vec3> polygon, const LinkOptions& options,
                                       std::uint16_t otherCell) {
    CellData& cell = cells_[handle];
    const Vec3 centre = centreOf(cell.walls);
    Vec3 inward = cutOpening(cell.walls, polygon);
    if (inward == Vec3(0.0))
        inward = centre - polygon.front();
    const bool facesInside = glm::dot(newellNormal(polygon), inward) > 0.0;
    if (facesInside != options.insideIsPositive)
        std::reverse(polygon.begin(), polygon.end());
    dat::CellPortal portal;
    portal.polygonId = static_cast<std::uint16_t>(cell.portals.size());
    portal.otherCellId = otherCell;
    portal.otherPortalId = dat::kNoPortal;
    if (options.exact)
        portal.flags |= dat::CellPortal::kExactMatch;
    if (options.insideIsPositive != options.wrongSideFlag)
        portal.flags |= dat::CellPortal::kPortalSide;
    cell.record.portals.push_back(portal);
    cell.portals.push_back({std::move(polygon), options.surface, options.twoSided});
    return {handle, portal.polygonId};
}

std::pair<TestWorld::Portal, TestWorld::Portal> TestWorld::link(Cell a, std::vector<Vec3> polygon, Cell b,
                                                                const LinkOptions& options) {
    const std::vector<Vec3> other = options.polygonInB.empty() ? polygon : options.polygonInB;
    const Portal pa = addPortal(a, std::move(polygon), options, static_cast<std::uint16_t>(id(b) & 0xFFFF));
    LinkOptions inB = options;
    inB.surface = options.surfaceInB;
    const Portal pb = addPortal(b, other, inB, static_cast<std::uint16_t>(id(a) & 0xFFFF));
    if (!options.oneWay) {
        cells_[a].record.portals[pa.index].otherPortalId = pb.index;
        cells_[b].record.portals[pb.index].otherPortalId = pa.index;
    } else {
        cells_[b].record.portals[pb.index].otherCellId = 0; // an opening that leads nowhere
    }
    return {pa, pb};
}

TestWorld::Portal TestWorld::openOutside(Cell cell, std::vector<Vec3> polygon, const LinkOptions& options) {
    return addPortal(cell, std::move(polygon), options, dat::kOutdoors);
}

std::uint32_t TestWorld::addBuilding(Walls exterior, std::vector<Portal> exits,
                                     const BuildingOptions& options) {
    SurfaceSlots slots([this](const std::string& name) { return surfaceId(name); });
    dat::Building building;
    MeshRecords mesh;
    dat::BspNode port;
    port.tag = dat::BspTag::Port;
    port.positive = 1;
    port.negative = 2;
    std::vector<std::vector<Vec3>> openings;
    for (const Portal& exit : exits) {
        openings.push_back(polygon(exit));
        cutOpening(exterior, openings.back());
        const dat::CellPortal& record = cells_[exit.cell].record.portals[exit.index];
        if ((record.flags & dat::CellPortal::kPortalSide) != 0)
            std::reverse(openings.back().begin(), openings.back().end());
        building.portals.push_back({static_cast<std::uint16_t>(record.flags | dat::CellPortal::kPortalSide),
                                    static_cast<std::uint16_t>(id(exit.cell) & 0xFFFF),
                                    exit.index,
                                    {}});
    }
    for (const Wall& wall : exterior)
        mesh.add(toLocal(options.frame, wall.points), slots.slot(wall.surface), wall.twoSided);
    const dat::PolygonList walls = mesh.polygons;
    for (std::size_t i = 0; i < openings.size(); ++i) {
        for (Vec3& p : openings[i])
            p += options.portalShift;
        const auto polygonId = mesh.add(toLocal(options.frame, openings[i]),
                                        slots.slot(portalSurface(options.portalSurface)), false);
        const auto index = static_cast<std::uint16_t>(i);
        port.portals.push_back(dat::PortalRef{polygonId, index});
    }
    dat::GfxObj model;
    model.id = nextModel_++;
    model.flags = dat::GfxObj::kDrawing | dat::GfxObj::kPhysics;
    model.physicsPolygons = walls;
    model.physicsBsp = leafTree();
    model.surfaces = slots.ids();
    model.vertexArray = std::move(mesh.vertices);
    model.polygons = std::move(mesh.polygons);
    model.drawingBsp.nodes = {port, dat::BspNode(), dat::BspNode()};
    addLevels(options.levels, model);
    portalFile_.add(model);
    building.model = model.id;
    building.frame = options.frame;
    building.numLeaves = 2;
    info(options.block.value_or(home_)).buildings.push_back(building);
    return model.id;
}

dat::LandBlock& TestWorld::terrain(dat::BlockCoord block) {
    dat::LandBlock& record = terrain_[dat::landBlockId(block)];
    record.id = dat::landBlockId(block);
    return record;
}

void TestWorld::setFlatTerrain(dat::BlockCoord block, std::uint8_t heightIndex, std::uint8_t type) {
    dat::LandBlock& record = terrain(block);
    record.heights.fill(heightIndex);
    record.terrain.fill(static_cast<std::uint16_t>(type << 2));
}

dat::LandBlockInfo& TestWorld::info(dat::BlockCoord block) {
    dat::LandBlockInfo& record = infos_[dat::landBlockInfoId(block)];
    record.id = dat::landBlockInfoId(block);
    return record;
}

std::uint32_t TestWorld::addModel(const Walls& walls, std::vector<dat::DegradeLevel> levels) {
    SurfaceSlots slots([this](const std::string& name) { return surfaceId(name); });
    MeshRecords mesh;
    for (const Wall& wall : walls)
        mesh.add(wall.points, slots.slot(wall.surface), wall.twoSided);
    dat::GfxObj model;
    model.id = nextModel_++;
    model.flags = dat::GfxObj::kDrawing | dat::GfxObj::kPhysics;
    model.physicsPolygons = mesh.polygons;
    model.physicsBsp = leafTree();
    model.surfaces = slots.ids();
    model.vertexArray = std::move(mesh.vertices);
    model.polygons = std::move(mesh.polygons);
    model.drawingBsp = leafTree();
    addLevels(std::move(levels), model);
    portalFile_.add(model);
    return model.id;
}

void TestWorld::addLevels(std::vector<dat::DegradeLevel> levels, dat::GfxObj& model) {
    if (levels.empty())
        return;
    for (dat::DegradeLevel& level : levels)
        level.gfxObj = level.gfxObj == kItself ? model.id : level.gfxObj;
    model.flags |= dat::GfxObj::kHasDegrade;
    model.degradeId = nextDegrade_++;
    portalFile_.add(dat::DegradeInfo{model.degradeId, std::move(levels)});
}

std::uint32_t TestWorld::addSetup(dat::Setup setup) {
    setup.id = nextSetup_++;
    portalFile_.add(setup);
    return setup.id;
}

void TestWorld::addObject(dat::BlockCoord block, std::uint32_t model, const dat::Frame& frame) {
    info(block).objects.push_back({model, frame});
}

void TestWorld::addStatic(Cell cell, std::uint32_t model, const dat::Frame& frame) {
    cells_[cell].record.flags |= dat::EnvCell::kHasStatics;
    cells_[cell].record.statics.push_back({model, frame});
}

dat::CellStruct TestWorld::cellStruct(CellData& cell) {
    SurfaceSlots slots([this](const std::string& name) { return surfaceId(name); });
    MeshRecords mesh;
    std::vector<Plane> planes;
    dat::CellStruct shape;
    for (const PortalPolygon& portal : cell.portals) {
        const std::vector<Vec3> local = toLocal(cell.record.position, portal.points);
        // The polygon has a surface, as most of the game's have.
        shape.portalPolygons.push_back(
            mesh.add(local, slots.slot(portalSurface(portal.surface)), portal.twoSided));
    }
    for (const Wall& wall : cell.walls) {
        const std::vector<Vec3> local = toLocal(cell.record.position, wall.points);
        mesh.add(local, slots.slot(wall.surface), wall.twoSided);
        if (const Plane plane = planeOf(local); !known(planes, plane))
            planes.push_back(plane);
    }
    const Vec3 centre = toLocal(cell.record.position, centreOf(cell.walls));
    for (const PortalPolygon& portal : cell.portals) {
        Plane plane = planeOf(toLocal(cell.record.position, portal.points));
        if (plane.signedDistance(centre) < 0.0)
            plane = plane.flipped();
        if (!known(planes, plane))
            planes.push_back(plane);
    }
    for (const std::uint32_t surface : slots.ids())
        cell.record.surfaces.push_back(static_cast<std::uint16_t>(surface & 0xFFFF));
    shape.vertexArray = std::move(mesh.vertices);
    shape.physicsPolygons.assign(mesh.polygons.begin() + std::ssize(cell.portals), mesh.polygons.end());
    shape.polygons = std::move(mesh.polygons);
    shape.cellBsp = cell.tree ? *cell.tree : cell.bsp ? chainTree(planes) : leafTree();
    shape.physicsBsp = leafTree();
    return shape;
}

Result<void> TestWorld::write(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    std::uint32_t next = 1;
    for (CellData& cell : cells_) {
        dat::Environment environment;
        environment.id = 0x0D000000u | next;
        cell.record.environment = static_cast<std::uint16_t>(next++);
        cell.record.cellStructure = 3; // a key, not a position in the list
        cell.record.surfaces.clear();
        environment.cells.emplace_back(3u, cellStruct(cell));
        portalFile_.add(environment);
        cellFile_.add(cell.record);
    }
    for (const auto& [word, count] : cellCounts_)
        info(dat::blockOf(word)).numCells = count;
    for (const auto& [id, record] : infos_) {
        cellFile_.add(record);
        terrain(dat::blockOf(id)).hasObjects = 1;
    }
    for (const auto& [id, record] : terrain_)
        cellFile_.add(record);
    if (writeRegion_)
        portalFile_.add(region_);
    if (Result<void> done = portalFile_.write(directory / "client_portal.dat"); !done)
        return done;
    return cellFile_.write(directory / "client_cell_1.dat");
}

} // namespace limen::test
