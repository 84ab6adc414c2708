#include "gpu/BatchSlots.h"

#include "gpu/PassSelection.h"

namespace limen::gpu {

bool hasSlots(const frame::Batch& batch, const RenderOptions& options) {
    return !drawsOpenings(batch.program) && batch.program != frame::Program::SkyPlain &&
           batch.program != frame::Program::Clearing && isDrawn(batch.program, options);
}

void assignSlots(const frame::FramePlan& plan, const RenderOptions& options, std::vector<BatchSlots>& slots) {
    slots.clear();
    std::uint32_t first = 0;
    for (const frame::Batch& batch : plan.batches) {
        const std::uint32_t end = first + (hasSlots(batch, options) ? batch.draws : 0);
        slots.push_back({first, end, end});
        first = end;
    }
}

} // namespace limen::gpu
