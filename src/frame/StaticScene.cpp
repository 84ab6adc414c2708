#include "frame/StaticScene.h"

#include "frame/PackInstance.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace limen::frame {

namespace {

bool shellsHaveCutOuts(const world::World& world) {
    return std::any_of(world.instances.begin(), world.instances.end(), [&](const world::Instance& instance) {
        bool isOne = false;
        if (instance.kind == world::InstanceKind::Shell)
            eachRangeOf(world.meshes[instance.mesh], instance.kind,
                        [&](DrawClass drawn, const world::Mesh::Range& range) {
                            isOne = isOne || (drawn == DrawClass::CutOut && range.indexCount > 0);
                        });
        return isOne;
    });
}

} // namespace

StaticScene::StaticScene(const world::World& world)
    : world_(world), clusters_(buildClusters(world)), clusterBatches_(clusters_),
      pieces_(buildPieces(world, clusters_)), meshPieces_(world), occluders_(world, clusters_),
      levels_(world, clusters_), members_(membersOfSpaces(world)), hasShellCutOuts_(shellsHaveCutOuts(world)),
      byObject_(world.instances.size()) {
    records_.reserve(world.instances.size());
    std::map<std::pair<world::SpaceIndex, std::uint32_t>, MemberRun> known; // by the only space and light set
    for (std::size_t i = 0; i < world.instances.size(); ++i) {
        const world::Instance& in = world.instances[i];
        const auto spaces = std::span(world.members).subspan(in.firstMember, in.memberCount);
        const std::uint32_t lightSet =
            i < world.instanceLightSets.size() ? world.instanceLightSets[i] : world::kNone;
        if (lightSet == world::kNone || spaces.size() != 1) {
            records_.push_back(packInstance(in, packMembers(world, spaces, {members_, 0}, lightSet)));
            continue;
        }
        const auto [entry, fresh] = known.try_emplace({spaces.front(), lightSet});
        if (fresh)
            entry->second = packMembers(world, spaces, {members_, 0}, lightSet);
        records_.push_back(packInstance(in, entry->second));
    }
    std::iota(byObject_.begin(), byObject_.end(), 0u);
    std::sort(byObject_.begin(), byObject_.end(), [&](world::InstanceIndex a, world::InstanceIndex b) {
        const std::uint64_t left = world.instances[a].object, right = world.instances[b].object;
        return left != right ? left < right : a < b;
    });
}

std::span<const world::InstanceIndex> StaticScene::instancesOf(std::uint64_t object) const {
    const auto objectOf = [&](world::InstanceIndex i) { return world_.instances[i].object; };
    const auto first =
        std::lower_bound(byObject_.begin(), byObject_.end(), object,
                         [&](world::InstanceIndex i, std::uint64_t wanted) { return objectOf(i) < wanted; });
    const auto end =
        std::find_if(first, byObject_.end(), [&](world::InstanceIndex i) { return objectOf(i) != object; });
    return {first, end};
}

} // namespace limen::frame
