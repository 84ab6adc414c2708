#include "world/assemble/DoorParts.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::world {
namespace {

/// The dress of one part as that of a model of its own.
Dress dressOfOne(std::uint32_t part, const Dress& dress) {
    Dress one;
    if (const DressedPart* worn = dress.part(part); worn != nullptr && !worn->textures.empty())
        one.parts[0].textures = worn->textures;
    one.overlays = dress.overlays;
    return one;
}

} // namespace

DoorMotion motionOf(const PlacedEntry& entry, Records& records) {
    const dat::Setup* setup = isSetup(entry.model) ? records.setup(entry.model) : nullptr;
    if (setup != nullptr)
        return doorMotionOf(*setup, entry.motionTable, records);
    DoorMotion motion;
    motion.keys = {{Pose()}};
    return motion;
}

std::vector<DoorPart> doorPartsOf(const PlacedEntry& entry, const Vec3& origin, const DoorMotion& motion,
                                  const Dress& dress, Models& models) {
    const Model dressed = dress.changesModel() ? models.dressed(entry.model, dress) : Model();
    std::vector<DoorPart> parts;
    for (const ModelPart& part : dress.changesModel() ? dressed.parts : models.model(entry.model).parts) {
        const PartMesh* mesh = models.part(part.gfxObj);
        if (part.held != kNone || mesh == nullptr || mesh->mesh.empty())
            continue;
        DoorPart made{part.gfxObj, part.scale * entry.scale, dressOfOne(part.part, dress), {}};
        for (const std::vector<Pose>& key : motion.keys) {
            const Pose pose = part.part < key.size() ? key[part.part] : Pose();
            made.keys.push_back({entry.orientation * pose.orientation,
                                 origin + entry.orientation * (pose.origin * entry.scale)});
        }
        parts.push_back(std::move(made));
    }
    return parts;
}

void addLeaves(std::span<const DoorPart> parts, InstanceKind kind, std::uint64_t object,
               BodyAssembler& bodies, World& world, Door& door) {
    door.firstLeaf = static_cast<std::uint32_t>(world.leaves.size());
    for (const DoorPart& part : parts) {
        LIMEN_ASSERT(!part.keys.empty(), "doorPartsOf() gives parts with a pose");
        Leaf leaf;
        leaf.model = part.gfxObj;
        leaf.body = bodies.add(part.gfxObj, kind, object, {.isAlwaysNear = true, .dress = part.dress});
        leaf.scale = part.scale;
        leaf.hinge = part.keys.front().origin;
        leaf.firstKey = static_cast<std::uint32_t>(world.leafKeys.size());
        leaf.keyCount = static_cast<std::uint32_t>(part.keys.size());
        const Vec3 size = glm::abs(part.scale);
        leaf.body.bounds = {leaf.body.bounds.centre * part.scale,
                            leaf.body.bounds.radius * std::max({size.x, size.y, size.z})};
        world.leafKeys.insert(world.leafKeys.end(), part.keys.begin(), part.keys.end());
        world.leaves.push_back(leaf);
    }
    door.leafCount = static_cast<std::uint32_t>(world.leaves.size()) - door.firstLeaf;
}

} // namespace limen::world
