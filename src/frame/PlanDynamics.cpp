#include "frame/PlanDynamics.h"

#include "core/Assert.h"
#include "frame/Highlights.h"
#include "frame/PackInstance.h"

namespace limen::frame {

namespace {

/// Dynamic instances whose mesh is prefetched ahead of the one that is planned.
constexpr std::size_t kMeshesAhead = 8;

/// Adds the change of one dynamic instance, by its index in the plan.
void change(const world::World& world, const FrameView& frame, const world::DynamicState& dynamics,
            std::uint32_t number, FramePlan& plan) {
    const world::Instance& instance = dynamics.instances[plan.dynamicInstances[number]];
    const auto spaces = std::span(dynamics.members).subspan(instance.firstMember, instance.memberCount);
    const MemberRun members = packMembers(world, spaces, {plan.members, plan.constants.staticMembers});
    plan.dynamicChanges.push_back({number, members.first, membersAndKind(members.count, instance.kind),
                                   colourOf(frame.highlights, instance.object)});
}

} // namespace

void planDynamics(const world::World& world, const FrameView& frame, const world::DynamicState& dynamics,
                  std::span<const SelectedDynamic> selected, DynamicPieces& pieces, FramePlan& plan) {
    LIMEN_ASSERT(plan.records.empty(), "dynamic instances are numbered before records");
    pieces.begin(plan);
    plan.dynamicRecords = recordsOf(dynamics.instances);
    const world::ListedInstances& listed = dynamics.listed;
    const std::size_t before = plan.dynamicInstances.size();
    plan.dynamicInstances.resize(before + selected.size());
    for (std::size_t i = 0; i < selected.size(); ++i) {
        if (i + kMeshesAhead < selected.size())
            pieces.prefetchFor(listed.mesh[selected[i + kMeshesAhead] & ~gpu::kGated]);
        const std::uint32_t at = selected[i] & ~gpu::kGated;
        const auto number = static_cast<std::uint32_t>(before + i);
        pieces.add(listed.mesh[at], plan.constants.staticInstances + number,
                   (selected[i] & gpu::kGated) != 0);
        plan.dynamicInstances[number] = listed.instance[at];
        if (listed.isListedAgain[at] != 0 || !frame.highlights.empty())
            change(world, frame, dynamics, number, plan);
    }
}

} // namespace limen::frame
