#include "world/assemble/UsableAssembler.h"

#include "world/LeafPose.h"

#include <algorithm>

namespace limen::world {
namespace {

bool moves(const DoorPart& part) {
    constexpr double kDiffers = 1e-3; // metres, and a difference of unit quaternions
    const LeafKey &shut = part.keys.front(), &open = part.keys.back();
    return glm::length(open.origin - shut.origin) > kDiffers ||
           std::abs(glm::dot(open.orientation, shut.orientation)) < 1.0 - kDiffers * kDiffers;
}

} // namespace

bool UsableAssembler::add(const PlacedEntry& entry, const Vec3& origin, const Dress& dress,
                          const ObjectSite& site) {
    if (!entry.mayOpen || entry.opacity < 1.0)
        return false;
    const DoorMotion motion = motionOf(entry, records_);
    if (!motion.isStill)
        return false;
    const std::vector<DoorPart> parts = doorPartsOf(entry, origin, motion, dress, models_);
    if (std::none_of(parts.begin(), parts.end(), moves))
        return false;
    Door door;
    door.name = entry.name;
    door.space = site.space;
    door.opaque = false;
    door.locked = entry.isLocked;
    door.open = entry.isOpen ? 1.0 : 0.0;
    door.seconds = motion.seconds;
    addLeaves(parts, InstanceKind::Static, dynamicObject(DynamicObject::Placed, entry.id), bodies_, world_,
              door);
    world_.doors.push_back(std::move(door));
    return true;
}

} // namespace limen::world
