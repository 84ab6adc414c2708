#include "world/block/CellReader.h"

#include "core/Assert.h"
#include "world/block/CellClosure.h"
#include "world/block/CellPortals.h"
#include "world/mesh/PolygonMesher.h"
#include "world/records/PolygonSource.h"
#include "world/records/Pose.h"

#include <algorithm>
#include <optional>

namespace limen::world {
namespace {

/// Limits of CellShape. Further directions are not used to prove cells disjoint.
constexpr std::size_t kMaxNormals = 64, kMaxEdges = 32;

void addDirection(std::vector<Vec3>& directions, Vec3 direction, std::size_t limit) {
    const double length = glm::length(direction);
    if (!(length > 1e-9) || directions.size() >= limit)
        return;
    direction /= length;
    const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vec3& d) {
        return std::abs(glm::dot(d, direction)) > 1.0 - 1e-8;
    });
    if (!known)
        directions.push_back(direction);
}

void addToShape(CellShape& shape, std::span<const Vec3> points) {
    addDirection(shape.normals, planeOf(points).n, kMaxNormals);
    for (std::size_t i = 0; i < points.size(); ++i) {
        addDirection(shape.edges, points[(i + 1) % points.size()] - points[i], kMaxEdges);
        shape.bounds.include(points[i]);
        shape.points.push_back(points[i]);
    }
}

/// A plane of a cell's tree, block-local. No value if its normal is zero or it is not finite.
std::optional<Plane> planeIn(const dat::BspNode& node, const Pose& pose) {
    const Vec3 n(node.plane.n);
    const double length = glm::length(n), d = node.plane.d;
    if (!(length > 1e-6) || !std::isfinite(length) || !std::isfinite(d))
        return std::nullopt;
    const Vec3 turned = pose.orientation * (n / length);
    return Plane{turned, d / length - glm::dot(turned, pose.origin)};
}

/// A cell's tree in block-local planes. A tree with an unusable plane becomes empty and contains no point.
std::vector<CellBspNode> treeOf(const dat::BspTree& tree, const Pose& pose) {
    struct Child {
        std::int32_t record = 0;
        std::uint32_t parent = kNone;
        bool isNegative = false;
    };
    std::vector<CellBspNode> nodes;
    std::vector<Child> open;
    if (!tree.nodes.empty() && tree.nodes[0].tag != dat::BspTag::Leaf)
        open.push_back({});
    while (!open.empty() && nodes.size() < tree.nodes.size()) {
        const Child child = open.back();
        open.pop_back();
        if (child.record < 0 || static_cast<std::size_t>(child.record) >= tree.nodes.size())
            continue;
        const dat::BspNode& record = tree.nodes[static_cast<std::size_t>(child.record)];
        const bool isLeaf =
            record.positive < 0 && record.negative < 0; // planes of others without children mean nothing
        if (isLeaf && !child.isNegative)
            continue; // a positive leaf is inside, which a missing child means, too
        const std::optional<Plane> plane =
            isLeaf ? Plane{} : planeIn(record, pose); // Plane{}: every point is on its positive side
        if (!plane)
            return {};
        const auto index = static_cast<std::uint32_t>(nodes.size());
        if (child.parent != kNone)
            (child.isNegative ? nodes[child.parent].negative : nodes[child.parent].positive) = index;
        nodes.push_back({*plane, kNone, kNone});
        if (isLeaf)
            continue;
        open.push_back({record.negative, index, true});
        open.push_back({record.positive, index, false});
    }
    return nodes;
}

/// The polygon id of each portal of the cell.
std::vector<std::uint16_t> portalPolygonIds(const dat::EnvCell& cell, const dat::CellStruct& shape,
                                            std::vector<Finding>& findings) {
    std::vector<std::uint16_t> ids;
    for (std::size_t i = 0; i < cell.portals.size(); ++i) {
        ids.push_back(cell.portals[i].polygonId);
        if (i < shape.portalPolygons.size() && shape.portalPolygons[i] != ids.back())
            note(findings, cell.id,
                 "portal " + std::to_string(i) + " names another polygon than its shape does");
    }
    if (shape.portalPolygons.size() > cell.portals.size())
        note(findings, cell.id, "its shape has more portal polygons than the cell has portals");
    return ids;
}

} // namespace

const dat::CellStruct* findShape(const dat::EnvCell& cell, Records& records) {
    const dat::Environment* environment = records.environment(0x0D000000u | cell.environment);
    if (environment == nullptr)
        return nullptr;
    for (const auto& [key, shape] : environment->cells)
        if (key == cell.cellStructure)
            return &shape;
    return nullptr;
}

std::vector<dat::RecordId> surfaceIds(const dat::EnvCell& cell) {
    std::vector<dat::RecordId> ids;
    for (const std::uint16_t surface : cell.surfaces)
        ids.push_back(0x08000000u | surface);
    return ids;
}

std::optional<CellDraft> draftCell(dat::EnvCell record, Records& records, BakedGeometry& geometry,
                                   std::vector<Finding>& findings) {
    CellDraft draft;
    draft.record = std::move(record);
    const dat::EnvCell& cell = draft.record;
    draft.shape = findShape(cell, records);
    if (draft.shape == nullptr) {
        note(findings, cell.id, "its shape does not exist");
        return std::nullopt;
    }
    const std::vector<std::uint16_t> portalIds = portalPolygonIds(cell, *draft.shape, findings);
    std::set<std::uint16_t> portals(draft.shape->portalPolygons.begin(), draft.shape->portalPolygons.end());
    portals.insert(portalIds.begin(), portalIds.end());
    const Pose pose = poseOf(cell.position);
    const Placement placement{glm::mat3_cast(pose.orientation), pose.origin};
    std::unordered_map<std::uint16_t, std::uint32_t> handles;
    for (SourcePolygon& polygon : readPolygons(draft.shape->vertexArray, draft.shape->polygons,
                                               drawnSlots(surfaceIds(cell), MeshOwner::Structure, records),
                                               portals, cell.id, findings)) {
        const std::uint16_t id = polygon.id;
        const bool drawn = polygon.isDrawn(), isPortal = polygon.isPortal;
        const std::uint32_t handle = geometry.add(std::move(polygon), placement);
        if (handle == kNone) {
            note(findings, cell.id, "polygon " + std::to_string(id) + " is too far from its block");
            continue;
        }
        if (drawn)
            draft.polygons.push_back(handle);
        if (isPortal)
            handles.emplace(id, handle);
    }
    for (const std::uint16_t id : portalIds) {
        const auto found = handles.find(id);
        draft.portals.push_back(found == handles.end() ? kNone : found->second);
    }
    const bool hasOpening = std::any_of(draft.portals.begin(), draft.portals.end(),
                                        [](std::uint32_t handle) { return handle != kNone; });
    if (draft.polygons.empty() && !hasOpening) {
        note(findings, cell.id, "none of its polygons can be used");
        return std::nullopt;
    }
    return draft;
}

void finishCell(const CellDraft& draft, const BakedGeometry& geometry, Records& records,
                BlockContent& block) {
    LIMEN_ASSERT(draft.shape != nullptr, "draftCell found a shape");
    LIMEN_ASSERT(block.cells.empty() || block.cells.back().id < draft.record.id,
                 "cells are in ascending order");
    CellContent cell;
    cell.id = draft.record.id;
    cell.seenOutside = (draft.record.flags & dat::EnvCell::kSeenOutside) != 0;
    cell.origin = poseOf(draft.record.position).origin;
    cell.surfaces = surfaceIds(draft.record);
    const std::vector<SurfaceList> lists = listsOf(cell.surfaces, records);
    PolygonMesher mesher(lists);
    CellClosure closure(geometry.vertices());
    std::vector<Vec3> points;
    for (const std::uint32_t handle : draft.polygons) {
        const SourcePolygon& source = geometry.source(handle);
        mesher.add(geometry, handle);
        if (source.isPortal)
            continue; // it bounds the cell as a portal
        for (const StitchLoop& loop : geometry.loops(handle)) {
            points.clear();
            for (const StitchCorner& corner : loop)
                points.push_back(geometry.vertices()[corner.vertex]);
            addToShape(cell.shape, points);
            closure.addDrawn(loop, source.frontSlot >= 0, source.backSlot >= 0);
        }
    }
    cell.clamp = mesher.clamped();
    cell.shell = mesher.finish();
    cell.bsp = treeOf(draft.shape->cellBsp, poseOf(draft.record.position));
    if (!draft.shape->cellBsp.nodes.empty() && cell.bsp.empty() &&
        draft.shape->cellBsp.nodes[0].tag != dat::BspTag::Leaf)
        note(block.findings, cell.id, "its cell tree has a plane without direction");
    cell.firstPortal = static_cast<std::uint32_t>(block.portals.size());
    cell.portalCount = static_cast<std::uint32_t>(draft.portals.size());
    const auto index = static_cast<std::uint32_t>(block.cells.size());
    for (PortalContent& portal :
         cellPortals(draft, index, {geometry, lists}, closure, cell.shape.points, block.findings)) {
        addToShape(cell.shape, portal.corners);
        block.portals.push_back(std::move(portal));
    }
    cell.shape.closed = closure.isClosed();
    if (!cell.shape.closed)
        note(block.findings, cell.id, "its shell is not closed: " + closure.describe());
    block.cells.push_back(std::move(cell));
}

} // namespace limen::world
