#include "world/assemble/PlacedDoorAssembler.h"

#include "core/Assert.h"

#include <algorithm>
#include <limits>

namespace limen::world {
namespace {

constexpr double kCovered = 0.9;    // share of an opening
constexpr double kThinnest = 0.004; // metres: a thinner leaf is in the plane of its filling
constexpr double kMoved = 0.001;    // metres: a door so near to its opening stays where it is

LeafKey placedKey(const PlacedEntry& entry, const Pose& pose) {
    return {entry.orientation * pose.orientation,
            entry.position + entry.orientation * (pose.origin * entry.scale)};
}

} // namespace

std::vector<PlacedDoorAssembler::Part> PlacedDoorAssembler::partsOf(const PlacedEntry& entry,
                                                                    double& seconds) {
    const dat::Setup* setup = isSetup(entry.model) ? records_.setup(entry.model) : nullptr;
    DoorMotion motion;
    if (setup != nullptr)
        motion = doorMotionOf(*setup, entry.motionTable, records_);
    else
        motion.keys = {{Pose()}};
    seconds = motion.seconds;
    std::vector<Part> parts;
    for (const ModelPart& part : models_.model(entry.model).parts) {
        const PartMesh* mesh = models_.part(part.gfxObj);
        if (mesh == nullptr || mesh->mesh.empty())
            continue;
        Part hung{part.gfxObj, part.scale * entry.scale, {}};
        for (const std::vector<Pose>& key : motion.keys)
            hung.keys.push_back(placedKey(entry, part.part < key.size() ? key[part.part] : Pose()));
        parts.push_back(std::move(hung));
    }
    return parts;
}

template <class Visit>
void PlacedDoorAssembler::eachVertex(const Part& part, Visit&& visit) {
    const PartMesh* mesh = models_.part(part.gfxObj);
    LIMEN_ASSERT(mesh != nullptr && !part.keys.empty(), "partsOf() gives parts with a mesh and a pose");
    const LeafKey& shut = part.keys.front();
    for (const MeshVertex& vertex : mesh->mesh.vertices)
        visit(shut.origin + shut.orientation * (Vec3(vertex.position) * part.scale));
}

DoorBox PlacedDoorAssembler::boxOf(const PlacedEntry& entry, const std::vector<Part>& parts) {
    const Mat3 axes = glm::mat3_cast(entry.orientation);
    Vec3 low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
    for (const Part& part : parts)
        eachVertex(part, [&](const Vec3& point) {
            const Vec3 local = glm::transpose(axes) * (point - entry.position);
            low = glm::min(low, local);
            high = glm::max(high, local);
        });
    return {entry.position + axes * ((low + high) * 0.5), {axes[0], axes[1], axes[2]}, (high - low) * 0.5};
}

bool PlacedDoorAssembler::add(const PlacedEntry& entry) {
    double seconds = 1.0;
    std::vector<Part> parts = partsOf(entry, seconds);
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
    for (Part& part : parts)
        for (LeafKey& key : part.keys)
            key.origin += isMoved ? opening->way : Vec3(0.0);
    const PortalIndex reciprocal = world_.portals[opening->portal].reciprocal;
    auto hung = std::find_if(hung_.begin(), hung_.end(), [&](const Hung& h) {
        return h.portal == opening->portal || (reciprocal != kNone && h.portal == reciprocal);
    });
    if (hung == hung_.end())
        hung = hung_.insert(hung_.end(), Hung{opening->portal, {}, {}, 0.0});
    hung->entries.push_back(&entry);
    hung->seconds = std::max(hung->seconds, seconds);
    hung->parts.insert(hung->parts.end(), parts.begin(), parts.end());
    return true;
}

bool PlacedDoorAssembler::isOpaque(const Hung& hung) {
    const Portal& portal = world_.portals[hung.portal];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::vector<Vec3> corners;
    for (const Part& part : hung.parts) {
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
    door.seconds = hung.seconds;
    door.firstLeaf = static_cast<std::uint32_t>(world_.leaves.size());
    for (const Part& part : hung.parts) {
        Leaf leaf;
        leaf.model = part.gfxObj;
        leaf.body = bodies_.add(part.gfxObj, InstanceKind::Filling, object);
        leaf.scale = part.scale;
        leaf.hinge = part.keys.front().origin;
        leaf.firstKey = static_cast<std::uint32_t>(world_.leafKeys.size());
        leaf.keyCount = static_cast<std::uint32_t>(part.keys.size());
        const Vec3 size = glm::abs(part.scale);
        leaf.body.bounds = {leaf.body.bounds.centre * part.scale,
                            leaf.body.bounds.radius * std::max({size.x, size.y, size.z})};
        world_.leafKeys.insert(world_.leafKeys.end(), part.keys.begin(), part.keys.end());
        world_.leaves.push_back(leaf);
    }
    door.leafCount = static_cast<std::uint32_t>(world_.leaves.size()) - door.firstLeaf;
    doors_.addPlaced(std::move(door), object);
}

void PlacedDoorAssembler::finish() {
    for (const Hung& hung : hung_)
        addDoor(hung);
    hung_.clear();
}

} // namespace limen::world
