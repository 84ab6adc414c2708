#include "world/assemble/PlacedDoorAssembler.h"

#include "core/Assert.h"
#include "world/OpeningParts.h"
#include "world/assemble/PlacedLook.h"

#include <algorithm>
#include <limits>

namespace limen::world {
namespace {

constexpr double kCovered = 0.9;    // share of an opening
constexpr double kThinnest = 0.004; // metres: a thinner leaf is in the plane of its filling
constexpr double kMoved = 0.001;    // metres: a door so near to its opening stays where it is

} // namespace

template <class Visit>
void PlacedDoorAssembler::eachVertex(const DoorPart& part, Visit&& visit) {
    const PartMesh* mesh = models_.part(part.gfxObj);
    LIMEN_ASSERT(mesh != nullptr && !part.keys.empty(), "doorPartsOf() gives parts with a mesh and a pose");
    const LeafKey& shut = part.keys.front();
    for (const MeshVertex& vertex : mesh->mesh.vertices)
        visit(shut.origin + shut.orientation * (Vec3(vertex.position) * part.scale));
}

DoorBox PlacedDoorAssembler::boxOf(const PlacedEntry& entry, const std::vector<DoorPart>& parts) {
    const Mat3 axes = glm::mat3_cast(entry.orientation);
    Vec3 low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
    for (const DoorPart& part : parts)
        eachVertex(part, [&](const Vec3& point) {
            const Vec3 local = glm::transpose(axes) * (point - entry.position);
            low = glm::min(low, local);
            high = glm::max(high, local);
        });
    return {entry.position + axes * ((low + high) * 0.5), {axes[0], axes[1], axes[2]}, (high - low) * 0.5};
}

bool PlacedDoorAssembler::add(const PlacedEntry& entry) {
    const DoorMotion motion = motionOf(entry, records_);
    std::vector<DoorPart> parts =
        doorPartsOf(entry, entry.position, motion, dressOf(entry, records_), models_);
    if (parts.empty())
        return false;
    const std::optional<DoorOpening> opening = findOpening(world_, boxOf(entry, parts));
    const auto isTaken = [&](const Door& door) {
        return door.portal == opening->portal || door.reciprocal == opening->portal;
    };
    // An opening that world.json fills has its door already.
    if (!opening || std::any_of(world_.doors.begin(), world_.doors.end(), isTaken))
        return false;
    const bool isMoved = glm::length(opening->way) > kMoved;
    for (DoorPart& part : parts)
        for (LeafKey& key : part.keys)
            key.origin += isMoved ? opening->way : Vec3(0.0);
    const PortalIndex reciprocal = world_.portals[opening->portal].reciprocal;
    auto hung = std::find_if(hung_.begin(), hung_.end(), [&](const Hung& h) {
        return h.portal == opening->portal || (reciprocal != kNone && h.portal == reciprocal);
    });
    if (hung == hung_.end())
        hung = hung_.insert(hung_.end(), Hung{opening->portal, {}, {}, 0.0});
    hung->entries.push_back(&entry);
    hung->seconds = std::max(hung->seconds, motion.seconds);
    hung->parts.insert(hung->parts.end(), parts.begin(), parts.end());
    return true;
}

bool PlacedDoorAssembler::isOpaque(const Hung& hung) {
    const Portal& portal = openingOf(world_, hung.portal);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::vector<Vec3> corners;
    for (const DoorPart& part : hung.parts) {
        std::vector<Vec3> points;
        eachVertex(part, [&](const Vec3& point) {
            points.push_back(point);
            low = std::min(low, portal.plane.signedDistance(point));
            high = std::max(high, portal.plane.signedDistance(point));
        });
        const MeshData& mesh = models_.part(part.gfxObj)->mesh;
        for (const std::uint32_t index : mesh.indices[static_cast<std::size_t>(SurfaceList::Opaque)])
            corners.push_back(points[index]);
    }
    return high - low >= kThinnest && coveredShare(world_, portal, corners) >= kCovered;
}

void PlacedDoorAssembler::addDoor(const Hung& hung) {
    const PlacedEntry& entry = *hung.entries.front();
    const std::uint64_t object = dynamicObject(DynamicObject::Placed, entry.id);
    Door door;
    door.name = entry.name;
    door.portal = hung.portal;
    door.reciprocal = world_.portals[hung.portal].reciprocal;
    door.opaque = isOpaque(hung);
    door.open = entry.isOpen ? 1.0 : 0.0;
    door.locked = std::any_of(hung.entries.begin(), hung.entries.end(),
                              [](const PlacedEntry* each) { return each->isLocked; });
    door.seconds = hung.seconds;
    addLeaves(hung.parts, InstanceKind::Filling, object, bodies_, world_, door);
    doors_.addPlaced(std::move(door), object);
}

void PlacedDoorAssembler::finish() {
    for (const Hung& hung : hung_)
        addDoor(hung);
    hung_.clear();
}

} // namespace limen::world
