#include "frame/Highlights.h"

#include <algorithm>

namespace limen::frame {

std::uint32_t colourOf(std::span<const Highlight> highlights, std::uint64_t object) {
    const auto found = std::find_if(highlights.rbegin(), highlights.rend(),
                                    [object](const Highlight& h) { return h.object == object; });
    return found != highlights.rend() ? found->colour : 0;
}

void replaceHighlighted(const StaticScene& scene, std::span<const Highlight> highlights, FramePlan& plan) {
    for (std::size_t i = 0; i < highlights.size(); ++i) {
        const std::uint64_t object = highlights[i].object;
        const std::span<const Highlight> before = highlights.first(i);
        if (std::any_of(before.begin(), before.end(),
                        [object](const Highlight& h) { return h.object == object; }))
            continue;
        for (const world::InstanceIndex instance : scene.instancesOf(object)) {
            plan.replacements.push_back(
                {instance,
                 plan.constants.staticInstances +
                     static_cast<std::uint32_t>(plan.dynamicInstances.size() + plan.records.size())});
            plan.records.push_back(scene.records()[instance]);
            plan.records.back().highlight = colourOf(highlights, object);
        }
    }
    plan.constants.replacementCount = static_cast<std::uint32_t>(plan.replacements.size());
}

} // namespace limen::frame
