#include "reference/SceneData.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::reference {
namespace {

Vec3 originOf(const world::World& world) {
    return world.blocks.empty() ? Vec3(0.0) : world.blocks.front().origin();
}

} // namespace

void BodyTable::add(const world::World& world, std::uint32_t where, const world::Instance& instance,
                    const Vec3& origin) {
    isUsed_.resize(bodies_.size());
    if (isUsed_[where] == 0) {
        isUsed_[where] = 1;
        used_.push_back(where);
    }
    Bodies& here = bodies_[where];
    here.solid.add(world, instance, world::SurfaceClass::Opaque, origin);
    here.solid.add(world, instance, world::SurfaceClass::CutOut, origin);
    here.blended.add(world, instance, world::SurfaceClass::Blended, origin);
}

void BodyTable::build() {
    for (const std::uint32_t where : used_) {
        bodies_[where].solid.build();
        bodies_[where].blended.build();
    }
}

void BodyTable::clear() {
    for (const std::uint32_t where : used_) {
        bodies_[where].solid.clear();
        bodies_[where].blended.clear();
        isUsed_[where] = 0;
    }
    used_.clear();
}

SceneData::SceneData(const world::World& of, const RuleOptions& with)
    : world(of), options(with), origin(originOf(of)), openings(of, origin) {
    LIMEN_ASSERT(!world.spaces.empty(), "a world has at least the outside");
    fixed.resize(world.spaces.size());
    moving.resize(world.spaces.size());
    for (world::SpaceIndex s = 0; s < world.spaces.size(); ++s) {
        const world::Space& space = world.spaces[s];
        for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i)
            addBodies(world.instances[world.spaceInstances[i]], s, fixed);
    }
    fixed.build();
    if (!options.objectsByZone)
        return;
    fixedByZone.resize(world.zones.size());
    movingByZone.resize(world.zones.size());
    std::vector<std::uint8_t> listed(world.instances.size(), 0);
    for (const world::InstanceIndex i : world.spaceInstances)
        listed[i] = 1;
    std::vector<world::Instance> resident; // one that no space lists is of the moment
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i) {
        if (listed[i] != 0)
            resident.push_back(world.instances[i]);
    }
    addByZone(resident, world.members, fixedByZone);
}

bool SceneData::goesByZone(const world::Instance& instance) const {
    const bool ofOneSpace = instance.kind == world::Kind::Shell || instance.kind == world::Kind::Terrain ||
                            instance.kind == world::Kind::Exterior;
    return options.objectsByZone && !ofOneSpace;
}

void SceneData::addBodies(const world::Instance& instance, world::SpaceIndex space, BodyTable& bySpace) {
    if (!goesByZone(instance))
        bySpace.add(world, space, instance, origin);
}

void SceneData::addByZone(std::span<const world::Instance> instances,
                          std::span<const world::SpaceIndex> members, BodyTable& byZone) {
    for (const world::Instance& instance : instances) {
        if (!goesByZone(instance))
            continue;
        std::vector<world::ZoneIndex> zones;
        for (const world::SpaceIndex s : members.subspan(instance.firstMember, instance.memberCount))
            zones.push_back(world.spaces[s].zone);
        std::sort(zones.begin(), zones.end());
        zones.erase(std::unique(zones.begin(), zones.end()), zones.end());
        for (const world::ZoneIndex zone : zones)
            byZone.add(world, zone, instance, origin);
    }
    byZone.build();
}

void SceneData::takeFillings(const world::Moment& moment) {
    shut = moment.closed;
    fillings.clear();
    std::size_t count = 0;
    if (!moment.fillings.empty())
        fillings.assign(moment.fillings.size(), world::kNone);
    for (std::size_t portal = 0; portal < moment.fillings.size(); ++portal) {
        const world::InstanceIndex instance = moment.fillings[portal];
        if (instance == world::kNone)
            continue;
        LIMEN_ASSERT(instance < moment.instances.size(), "a filling is one of the moment's instances");
        if (fillingSurfaces.size() <= count)
            fillingSurfaces.emplace_back();
        TriangleSet& surface = fillingSurfaces[count];
        surface.clear();
        for (const auto surfaces :
             {world::SurfaceClass::Opaque, world::SurfaceClass::CutOut, world::SurfaceClass::Blended})
            surface.add(world, moment.instances[instance], surfaces, origin);
        fillings[portal] = static_cast<std::uint32_t>(count++);
    }
}

void SceneData::takeMoment(const world::Moment& moment) {
    LIMEN_ASSERT(moment.firstInSpace.empty() || moment.firstInSpace.size() == world.spaces.size() + 1,
                 "a moment is of the scene's world");
    LIMEN_ASSERT(moment.closed.empty() || moment.closed.size() == world.portals.size(),
                 "a moment is of the scene's world");
    moving.clear();
    movingByZone.clear();
    for (world::SpaceIndex s = 0; s < world.spaces.size(); ++s) {
        for (const world::InstanceIndex i : moment.instancesIn(s))
            addBodies(moment.instances[i], s, moving);
    }
    moving.build();
    if (options.objectsByZone)
        addByZone(moment.instances, moment.members, movingByZone);
    takeFillings(moment);
}

} // namespace limen::reference
