#include "world/assemble/BakedInstance.h"

namespace limen::world {

Instance& addBakedInstance(const JoiningBlock& block, InstanceKind kind, const MeshData& data,
                           std::uint64_t contentKey, MeshArena& arena, World& world) {
    Instance instance;
    instance.kind = kind;
    instance.mesh = arena.add(data, contentKey);
    instance.block = block.index;
    instance.bounds = world.meshes[instance.mesh].bounds;
    instance.bounds.centre += block.origin;
    instance.placedIn = kOutside;
    world.instances.push_back(instance);
    return world.instances.back();
}

} // namespace limen::world
