#include "CallList.h"

#include "core/Hash.h"

namespace limen::bench {

namespace {

constexpr std::uint32_t kStageMark = 0x10000; // beyond all program numbers

/// The properties of a plan that determine its GL calls: stages, and program and gate of each batch.
std::vector<std::uint32_t> listOf(const frame::FramePlan& plan) {
    std::vector<std::uint32_t> list;
    for (const frame::Stage& stage : plan.stages) {
        list.push_back(kStageMark + static_cast<std::uint32_t>(stage.kind));
        for (std::uint32_t i = 0; i < stage.batchCount; ++i) {
            const frame::Batch& batch = plan.batches[stage.firstBatch + i];
            list.push_back(static_cast<std::uint32_t>(batch.program) * 2 + (batch.gated ? 1 : 0));
        }
    }
    return list;
}

} // namespace

void CallList::add(const frame::FramePlan& plan, std::uint32_t calls) {
    const auto [entry, fresh] = calls_.try_emplace(listOf(plan), calls);
    same_ = same_ && entry->second == calls;
    frames_.push_back(calls);
}

std::uint32_t CallList::most() const {
    return frames_.empty() ? 0 : *std::max_element(frames_.begin(), frames_.end());
}

std::uint64_t CallList::hash() const {
    Hash hash;
    for (const std::uint32_t calls : frames_)
        hash.add(calls);
    return hash.value();
}

} // namespace limen::bench
