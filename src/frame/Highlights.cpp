#include "frame/Highlights.h"

#include "frame/PackInstance.h"

#include <algorithm>
#include <numeric>

namespace limen::frame {

std::uint32_t colourOf(std::span<const Highlight> highlights, std::uint64_t object) {
    const auto found = std::find_if(highlights.rbegin(), highlights.rend(),
                                    [object](const Highlight& h) { return h.object == object; });
    return found != highlights.rend() ? found->colour : 0;
}

Highlights::Highlights(const world::World& world) : world_(world), byObject_(world.instances.size()) {
    std::iota(byObject_.begin(), byObject_.end(), 0u);
    std::sort(byObject_.begin(), byObject_.end(), [&](world::InstanceIndex a, world::InstanceIndex b) {
        const std::uint64_t left = world.instances[a].object, right = world.instances[b].object;
        return left != right ? left < right : a < b;
    });
}

void Highlights::replace(std::span<const Highlight> highlights, FramePlan& plan) const {
    for (std::size_t i = 0; i < highlights.size(); ++i) {
        const std::uint64_t object = highlights[i].object;
        const std::span<const Highlight> before = highlights.first(i);
        if (std::none_of(before.begin(), before.end(),
                         [object](const Highlight& h) { return h.object == object; }))
            replaceObject(object, colourOf(highlights, object), plan);
    }
    plan.constants.replacementCount = static_cast<std::uint32_t>(plan.replacements.size());
}

void Highlights::replaceObject(std::uint64_t object, std::uint32_t colour, FramePlan& plan) const {
    const auto objectOf = [&](world::InstanceIndex i) { return world_.instances[i].object; };
    auto next =
        std::lower_bound(byObject_.begin(), byObject_.end(), object,
                         [&](world::InstanceIndex i, std::uint64_t wanted) { return objectOf(i) < wanted; });
    for (; next != byObject_.end() && objectOf(*next) == object; ++next) {
        gpu::Instance record = packInstance(world_, world_.instances[*next], world_.members,
                                            {plan.moverMembers, plan.constants.staticMembers});
        record.highlight = colour;
        plan.replacements.push_back(
            {*next, plan.constants.staticInstances +
                        static_cast<std::uint32_t>(plan.movers.size() + plan.records.size())});
        plan.records.push_back(record);
    }
}

} // namespace limen::frame
